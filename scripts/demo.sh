#!/usr/bin/env bash
# The demonstration: tests the unprotected airbag of Paper I until it fires without cause, and the quadcopters of
# Paper III until a fault makes them collide. Those failures are what the demonstration is for, so finding them is exit
# status 0. SEED=N draws other tests: they find other failures, and one in ten takes half a minute to shrink.
set -euo pipefail
cd "$(dirname "$0")/.."
seed=${SEED:-3}

# Runs a module of properties that must fail; what is said of it afterwards.
must_fail() {
  local status=0
  QUIET=1 rebar3 proper -d demo -m "$1" -p "$2" --seed "$seed" || status=$?
  echo
  case $status in
    1) echo "$3" ;;
    0) echo "demo: the violation was not found, which is a defect of FaultCheck" >&2; exit 1 ;;
    *) exit $status ;;
  esac
}

echo "Building (the first time takes a few minutes; log: _build/native.log) ..."
mkdir -p _build
scripts/build_native.sh release >_build/native.log 2>&1 || { tail -n 30 _build/native.log >&2; exit 3; }
echo "Testing C code: an airbag must not fire unless it is told to, whatever happens to its packets."
echo
must_fail prop_airbag_demo prop_never_fires_without_cause \
  "The airbag fired without cause: above are the shortest commands that make it, and how to repeat them."
echo
echo "Testing a simulator: quadcopters must not collide, whatever happens to their sensors and radio."
echo
must_fail prop_copter_demo prop_copters_survive_faults \
  "Copters collided: above are the shortest commands that make them, and how to repeat them. The same flight again:"
echo
cases=${FAULTCHECK_CASES:-cases}
# The newest file of a property's cases; nothing when there is none.
newest() { # newest PROPERTY FILE
  find "$cases" -path "*/$1-*/$2" -printf '%T@ %p\n' | sort -n | tail -1 | cut -d ' ' -f 2-
}
flight=$(newest prop_copters_survive_faults scenario.json)
_build/native/bin/coptersim_run --replay --speed 10 --out "$(dirname "$flight")/trace.json" "$flight"

echo
echo "The failures as pages, to be opened in a browser (no network, no server; they can be sent to others):"
for property in prop_never_fires_without_cause prop_copters_survive_faults; do
  page=$(newest "$property" report.html)
  # The page of a flight is made from the visualizer's; where that is not built, the note above tells how.
  [ -z "$page" ] || echo "  xdg-open $page"
done
