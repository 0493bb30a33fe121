#!/usr/bin/env bash
# EUnit and, where there are suites, Common Test.
source "$(dirname "$0")/lib.sh"
export FAULTCHECK_CASES="$root/_build/test/cases"

# run NAME COMMAND...: runs rebar3, shows its output when it fails, counts from the summary it prints.
run() {
  local name=$1 log
  shift
  log="$reports/$name.log"
  "$@" 2>&1 | plain >"$log"
  status=${PIPESTATUS[0]}
  [ $status -eq 0 ] || { all_status=1; tail -n 80 "$log"; }
}

all_status=0
run eunit rebar3 eunit
# "N tests, M failures, K cancelled"
read -r tests bad < <(
  sed -nE 's/^([0-9]+) tests?, ([0-9]+) failures?.*/\1 \2/p' "$reports/eunit.log" | tail -1)
passed=$((passed + ${tests:-0} - ${bad:-0}))
failed=$((failed + ${bad:-0}))

if compgen -G 'apps/*/test/*_SUITE.erl' >/dev/null; then
  run ct rebar3 ct
  # "All N tests passed." or "Failed N tests. [Skipped N (...) tests. ]Passed N tests."
  good=$(sed -nE 's/.*(All|Passed) ([0-9]+) tests.*/\2/p' "$reports/ct.log" | tail -1)
  bad=$(sed -nE 's/.*Failed ([0-9]+) tests.*/\1/p' "$reports/ct.log" | tail -1)
  passed=$((passed + ${good:-0}))
  failed=$((failed + ${bad:-0}))
fi
finish $all_status
