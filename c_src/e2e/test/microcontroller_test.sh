#!/usr/bin/env bash
# What a microcontroller needs to hold of libe2e: microcontroller_test.sh LIBRARY.so ARCHIVE.a
#
# The shared library exports the public functions and nothing else; the freestanding archive (bitwise checksums, -Os)
# has no writable data and needs nothing from outside but memcpy and memset, which compilers may always call.
set -uo pipefail
failed=0
expect_nothing() {
  local text=$1 found=$2
  if [ -n "$found" ]; then
    printf '%s:\n%s\n' "$text" "$found" >&2
    failed=1
  fi
}
exported=$(nm -D --defined-only "$1" | awk '{ print $3 }')
[ "$(grep -c -E '^(E2E|Crc)_' <<<"$exported")" -ge 70 ] || { echo "public functions are missing" >&2; failed=1; }
expect_nothing "exported but not public" "$(grep -v -E '^(E2E|Crc)_' <<<"$exported")"

own=$(nm "$2" | awk '$2 ~ /^[TRD]$/ { print $3 }' | sort -u)
wanted=$(nm "$2" | awk '$1 == "U" { print $2 }' | sort -u)
expect_nothing "needed from outside" "$(comm -23 <(echo "$wanted") <(echo "$own") | grep -v -x -E 'memcpy|memset')"
expect_nothing "writable data" "$(size "$2" | awk 'NR > 1 && $2 + $3 > 0')"
exit $failed
