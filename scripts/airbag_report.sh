#!/usr/bin/env bash
# Repeats the experiments of Paper I and writes _build/reports/airbag.md with its charts. Goes on where an interrupted
# run ended. The airbag's own output goes to airbag.log there,
# which stays when something failed.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null
mkdir -p _build/reports
ERL_LIBS="$root/_build/default/lib" erl -noinput -run airbag_report main _build/reports >_build/reports/airbag.log
rm _build/reports/airbag.log
echo "written: _build/reports/airbag.md"
