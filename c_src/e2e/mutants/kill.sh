#!/usr/bin/env bash
# Builds libe2e with each seeded defect in turn and lets the C tests judge it.
#
#   kill.sh DIRECTORY TEST...     each TEST is a program that must fail on a defective library
#
# A TEST finds the library under test through LD_LIBRARY_PATH. Prints a line for each defect and the score; exit
# status 1 when a defect survives. DIRECTORY is for intermediate files; the compiler is $CC, or cc.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
work=$1
shift

"$here/build.sh" 0 "$work" >/dev/null || exit 2
for test in "$@"; do
  LD_LIBRARY_PATH="$work/lib" "$test" >/dev/null 2>&1 || { echo "$test fails without a defect" >&2; exit 2; }
done

total=0
killed=0
for number in $("$here/apply.sh" --numbers); do
  built=$("$here/build.sh" "$number" "$work") || { echo "defect $number does not compile" >&2; exit 2; }
  total=$((total + 1))
  verdict=survived
  for test in "$@"; do
    if ! LD_LIBRARY_PATH="$work/lib" timeout 60 "$test" >/dev/null 2>&1; then
      verdict="killed by $(basename "$test")"
      killed=$((killed + 1))
      break
    fi
  done
  printf '%2d %s: %s\n' "$number" "${built%%$'\n'*}" "$verdict"
done
echo "$killed of $total defects killed"
[ "$killed" -eq "$total" ]
