#!/usr/bin/env bash
# Release build of the C side and of the Erlang applications, warnings as errors.
source "$(dirname "$0")/lib.sh"
check "native release build" scripts/build_native.sh release
check "rebar3 compile" rebar3 compile
finish
