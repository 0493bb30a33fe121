#!/usr/bin/env bash
# Repeats the experiments of Paper I and writes _build/reports/airbag.md with its charts.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null
mkdir -p _build/reports
ERL_LIBS="$root/_build/default/lib" erl -noinput -eval '
  try airbag_report:write("_build/reports"), halt(0)
  catch _:Reason -> io:format(standard_error, "airbag-report: ~0tp~n", [Reason]), halt(1) end.'
echo "written: _build/reports/airbag.md"
