#!/usr/bin/env bash
# Flies the figures of Papers II and III again and checks their orderings; writes _build/reports/copter_figures.md and
# charts. Exit status 1 when an ordering does not hold.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null
mkdir -p _build/reports
ERL_LIBS="$root/_build/default/lib" erl -noinput -run copter_figures main _build/reports
echo "written: _build/reports/copter_figures.md"
