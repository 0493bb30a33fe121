#!/usr/bin/env bash
# Writes a copy of libfaultcheck's sources with one seeded defect.
#
#   apply.sh NUMBER DIRECTORY    the copy goes into DIRECTORY/src and DIRECTORY/embedded; prints what is wrong and the
#                                file, one line each
#   apply.sh --numbers           prints the numbers of all defects
#
# Exit status 2 when there is no such defect or its line is not in the file as defects.txt says.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
list="$here/defects.txt"

if [ "${1:-}" = --numbers ]; then
  awk '/^[0-9]+ / { print $1 }' "$list"
  exit
fi
[ $# -eq 2 ] || { echo "usage: apply.sh NUMBER DIRECTORY | apply.sh --numbers" >&2; exit 2; }
number=$1
out=$2

mapfile -t defect < <(awk -v number="$number" '
  /^[0-9]+ /  { found = $1 == number; sub(/^[0-9]+ /, ""); if (found) title = $0; next }
  !found || /^#/ || /^$/ { next }
  /^- /       { old = substr($0, 3); next }
  /^\+ /      { new = substr($0, 3); next }
  /^nth /     { nth = $2; next }
              { file = $0 }
  END         { if (title != "") printf "%s\n%s\n%d\n%s\n%s\n", title, file, nth, old, new }' "$list")
[ ${#defect[@]} -eq 5 ] || { echo "apply: no defect $number in $list" >&2; exit 2; }
title=${defect[0]} file=${defect[1]} nth=${defect[2]}

mkdir -p "$out/src" "$out/embedded"
cp "$here"/../src/*.{cpp,h,map} "$out/src/"
cp "$here"/../embedded/fi.{c,h} "$out/embedded/"
OLD=${defect[3]} NEW=${defect[4]} awk -v nth="$nth" '
  { line = $0; gsub(/^ +| +$/, "", line) }
  line == ENVIRON["OLD"] {
    seen++
    if (nth == 0 || seen == nth) { indent = $0; sub(/[^ ].*/, "", indent); $0 = indent ENVIRON["NEW"]; done++ }
  }
  { print }
  END { exit done != 1 }' "$here/../$file" >"$out/$file" || {
  echo "apply: defect $number: its line must occur once in $file: ${defect[3]}" >&2
  exit 2
}
printf '%s\n%s\n' "$title" "$file"
