#!/usr/bin/env bash
# The demonstration: tests the unprotected airbag of Paper I until it fires without cause. That failure is what the
# demonstration is for, so finding it is exit status 0.
set -euo pipefail
cd "$(dirname "$0")/.."

echo "Building (the first time takes a few minutes; log: _build/native.log) ..."
mkdir -p _build
scripts/build_native.sh release >_build/native.log 2>&1 || { tail -n 30 _build/native.log >&2; exit 3; }
echo "Testing C code: an airbag must not fire unless it is told to, whatever happens to its packets."
echo
status=0
QUIET=1 rebar3 proper -d demo -m prop_airbag_demo || status=$?
echo
case $status in
  1) echo "The airbag fired without cause: above are the shortest commands that make it, and how to repeat them." ;;
  0) echo "demo: the violation was not found, which is a defect of FaultCheck" >&2; exit 1 ;;
  *) exit $status ;;
esac
