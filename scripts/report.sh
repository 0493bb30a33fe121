#!/usr/bin/env bash
# Runs what `make NAME-report` and the like measure: scripts/report.sh MODULE NAME [LOG]
#
# MODULE:main/1 writes _build/reports/NAME.md with its charts and decides the exit status; many go on where an
# interrupted run ended. With LOG, what the code under test prints goes to _build/reports/NAME.log, which stays when
# something failed.
set -euo pipefail
cd "$(dirname "$0")/.."
module=$1 name=$2 log=${3:-}
scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null
mkdir -p _build/reports
measure() { ERL_LIBS="$PWD/_build/default/lib" erl -noinput -run "$module" main _build/reports; }
if [ -n "$log" ]; then
  measure >"_build/reports/$name.log"
  rm "_build/reports/$name.log"
else
  measure
fi
echo "written: _build/reports/$name.md"
