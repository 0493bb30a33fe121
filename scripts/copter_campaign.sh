#!/usr/bin/env bash
# Measures which configuration of the quadcopters survives which faults; writes _build/reports/copter_campaign.md, .json
# and a chart. Interrupted, it goes on where it ended.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null
mkdir -p _build/reports
ERL_LIBS="$root/_build/default/lib" erl -noinput -run copter_campaign main _build/reports
echo "written: _build/reports/copter_campaign.md"
