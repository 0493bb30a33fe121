#!/usr/bin/env bash
# Builds libe2e with each seeded defect in turn and lets the tests judge it.
#
#   kill.sh CC DIRECTORY TEST...     each TEST is a program that must fail on a defective library
#
# A TEST finds the library under test through LD_LIBRARY_PATH. Prints a line for each defect and the score; exit
# status 1 when a defect survives. DIRECTORY is for intermediate files.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cc=$1
work=$2
shift 2
soname=libe2e.so.$(cut -d . -f 1 "$here/../../../VERSION")
flags=(-std=c99 -O1 -w -fPIC -fvisibility=hidden -DE2E_CRC_METHOD=E2E_CRC_SLICED -I "$here/../include")

compile() { # SOURCE OBJECT
  "$cc" "${flags[@]}" -c "$1" -o "$2"
}

rm -rf "$work"
mkdir -p "$work/good"
for source in "$here"/../src/*.c; do
  compile "$source" "$work/good/$(basename "$source" .c).o" || exit 2
done
"$cc" -shared -Wl,-soname,"$soname" "$work"/good/*.o -o "$work/$soname" || exit 2
for test in "$@"; do
  LD_LIBRARY_PATH="$work" "$test" >/dev/null 2>&1 || { echo "$test fails without a defect" >&2; exit 2; }
done

# Compiles anew what the changed file is part of.
rebuild() { # FILE
  local source
  cp "$work"/good/*.o "$work/mutant/"
  for source in "$work"/mutant/src/*.c; do
    if [ "src/$(basename "$source")" = "$1" ] || grep -q "\"$(basename "$1")\"" "$source" ||
      { [ "$1" = src/nibble.h ] && grep -q p01_packet.h "$source"; }; then
      compile "$source" "$work/mutant/$(basename "$source" .c).o" || return 1
    fi
  done
  "$cc" -shared -Wl,-soname,"$soname" "$work"/mutant/*.o -o "$work/$soname"
}

total=0
killed=0
for number in $("$here/apply.sh" --numbers); do
  rm -rf "$work/mutant"
  applied=$("$here/apply.sh" "$number" "$work/mutant") || exit 2
  total=$((total + 1))
  rebuild "${applied##*$'\n'}" || { echo "defect $number does not compile" >&2; exit 2; }
  verdict=survived
  for test in "$@"; do
    if ! LD_LIBRARY_PATH="$work" timeout 60 "$test" >/dev/null 2>&1; then
      verdict="killed by $(basename "$test")"
      killed=$((killed + 1))
      break
    fi
  done
  printf '%2d %s: %s\n' "$number" "${applied%%$'\n'*}" "$verdict"
done
echo "$killed of $total defects killed"
[ "$killed" -eq "$total" ]
