#!/usr/bin/env bash
# Runs a stored case again: scripts/replay.sh cases/<id> (or <id> alone)
#
# A case with a flight of quadcopters (scenario.json) is also flown, in real time unless SPEED says otherwise
# (0: without waiting). SET="name=value ..." flies it with other gains or parameters, BISECT=name=low:high looks for the
# smallest value with which it does not collide; then only the flight is run. A flight that was kept without a case
# (it has no case.json) is only flown.
set -euo pipefail
cd "$(dirname "$0")/.."
case=${1:-}
if [ -z "$case" ]; then
  echo "replay: say which case: make replay CASE=cases/<id>; stored are:" >&2
  ls "${FAULTCHECK_CASES:-cases}" 2>/dev/null >&2
  exit 2
fi
cases=${FAULTCHECK_CASES:-cases}
if [ ! -e "$case" ] && [ -d "$cases/$case" ]; then case=$cases/$case; fi
scripts/build_native.sh release >/dev/null
flight="$case/scenario.json"

fly() {
  local set=()
  for assignment in ${SET:-}; do set+=(--set "$assignment"); done
  _build/native/bin/coptersim_run "${set[@]}" "$@" "$flight"
}

if [ -n "${SET:-}${BISECT:-}" ] && [ ! -f "$flight" ]; then
  echo "replay: $case has no scenario.json: SET and BISECT are for flights of quadcopters" >&2
  exit 2
fi
if [ -n "${BISECT:-}" ]; then
  fly --bisect "$BISECT"
  exit
fi
status=0
if [ -z "${SET:-}" ] && { [ -e "$case/case.json" ] || [ ! -f "$flight" ]; }; then
  rebar3 compile >/dev/null
  bin/faultcheck replay "$case" || status=$?
fi
if [ -f "$flight" ] && [ $status -le 1 ]; then
  fly --replay --speed "${SPEED:-1}" --out "$case/trace.json"
  echo "written: $case/trace.json"
fi
exit $status
