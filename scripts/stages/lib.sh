# Sourced by every test stage. A stage runs one kind of test and reports how many passed and failed.
#
#   FC_RESULT   file that gets one line "PASSED FAILED"; the driver (scripts/test.sh) reads it
# shellcheck shell=bash
set -uo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
cd "$root" || exit 2
FC_RESULT=${FC_RESULT:-/dev/stdout}
reports="$root/_build/reports/test"
mkdir -p "$reports"

passed=0
failed=0

# rebar3 colours what it prints, also into files.
plain() { sed 's/\x1b\[[0-9;]*m//g'; }

# check TEXT COMMAND...: one check; its output is shown only when it fails.
check() {
  local text=$1 output
  shift
  if output=$("$@" 2>&1); then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED: %s\n%s\n' "$text" "$(head -n 20 <<<"$output")" | plain
  fi
}

# count_junit FILE...: adds up the test cases of JUnit files.
count_junit() {
  local file counts
  for file in "$@"; do
    counts=$(tr '\n' ' ' <"$file" | sed 's/<testcase/\n<testcase/g' | awk '
      /^<testcase/ { n++; if ($0 ~ /<failure|<error/) bad++; else if ($0 ~ /<skipped/) skipped++ }
      END { print n - bad - skipped, bad + 0 }')
    passed=$((passed + ${counts% *}))
    failed=$((failed + ${counts#* }))
  done
}

# finish STATUS: writes the result; a stage whose tool failed without a failed test counts as one failure.
finish() {
  local status=${1:-0}
  if [ "$status" -ne 0 ] && [ "$failed" -eq 0 ]; then failed=1; fi
  echo "$passed $failed" >"$FC_RESULT"
  [ "$failed" -eq 0 ]
  exit
}
