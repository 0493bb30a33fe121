#!/usr/bin/env bash
# Measures what guided search brings over chance on the quadcopters; writes _build/reports/search.md and search.json.
# Interrupted, it goes on where it ended.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null
mkdir -p _build/reports
ERL_LIBS="$root/_build/default/lib" erl -noinput -run copter_search_report main _build/reports
echo "written: _build/reports/search.md"
