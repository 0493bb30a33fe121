#!/usr/bin/env bash
# Measures what each E2E profile detects and writes _build/reports/e2e.md.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null
mkdir -p _build/reports
ERL_LIBS="$root/_build/default/lib" erl -noinput -run e2e_report main _build/reports
echo "written: _build/reports/e2e.md"
