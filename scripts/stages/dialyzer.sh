#!/usr/bin/env bash
# Dialyzer over all applications: one check, its warnings are the failures.
source "$(dirname "$0")/lib.sh"
check "dialyzer" rebar3 dialyzer
finish
