#!/usr/bin/env bash
# Dialyzer over all applications: one check, its warnings are the failures.
source "$(dirname "$0")/lib.sh"
rm -f _build/default/*.dialyzer_warnings
rebar3 dialyzer 2>&1 | plain >"$reports/dialyzer.log"
status=${PIPESTATUS[0]}
if [ "$status" -eq 0 ]; then
  passed=1
else
  failed=1
  plain <"$(ls _build/default/*.dialyzer_warnings 2>/dev/null || echo "$reports/dialyzer.log")" | head -n 100
fi
finish
