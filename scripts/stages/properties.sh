#!/usr/bin/env bash
# Every property of every application, with our own `rebar3 proper`.
source "$(dirname "$0")/lib.sh"
export FAULTCHECK_CASES="$root/_build/test/cases"
xml="$reports/properties.xml"
rm -f "$xml"
rebar3 proper --junit "$xml" 2>&1 | plain >"$reports/properties.log"
status=${PIPESTATUS[0]}
[ $status -eq 0 ] || tail -n 60 "$reports/properties.log"
[ -f "$xml" ] && count_junit "$xml"
finish $status
