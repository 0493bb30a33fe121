#!/usr/bin/env bash
# Repeats the experiments of Paper I and writes _build/reports/airbag.md with its charts. Goes on where an interrupted
# run ended.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null
mkdir -p _build/reports
ERL_LIBS="$root/_build/default/lib" erl -noinput -run airbag_report main _build/reports
echo "written: _build/reports/airbag.md"
