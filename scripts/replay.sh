#!/usr/bin/env bash
# Runs a stored case again: scripts/replay.sh cases/<id>
set -euo pipefail
cd "$(dirname "$0")/.."
case=${1:-}
if [ -z "$case" ]; then
  echo "replay: say which case: make replay CASE=cases/<id>; stored are:" >&2
  ls "${FAULTCHECK_CASES:-cases}" 2>/dev/null >&2
  exit 2
fi
scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null
exec bin/faultcheck replay "$case"
