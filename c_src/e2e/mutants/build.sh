#!/usr/bin/env bash
# Builds libe2e with one seeded defect, in a second: only what the defect is in is compiled anew.
#
#   build.sh NUMBER DIRECTORY    NUMBER 0: no defect. Writes DIRECTORY/lib/libe2e.so and keeps what can be used again
#
# Prints what is wrong and in which file, one line each. The compiler is $CC, or cc. Exit status 2 when the defect does
# not exist or does not compile.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
[ $# -eq 2 ] || { echo "usage: build.sh NUMBER DIRECTORY" >&2; exit 2; }
number=$1
work=$2
soname=libe2e.so.$(cut -d . -f 1 "$here/../../../VERSION")
flags=(-std=c99 -O1 -g -w -fPIC -fvisibility=hidden -DE2E_CRC_METHOD=E2E_CRC_SLICED -I "$here/../include")

compile() { # SOURCE DIRECTORY
  "${CC:-cc}" "${flags[@]}" -c "$1" -o "$2/$(basename "$1" .c).o"
}

if [ ! -f "$work/good/done" ]; then
  mkdir -p "$work/good"
  for source in "$here"/../src/*.c; do compile "$source" "$work/good" || exit 2; done
  touch "$work/good/done"
fi

rm -rf "${work:?}/mutant" "${work:?}/lib"
mkdir -p "$work/mutant" "$work/lib"
cp "$work"/good/*.o "$work/mutant/"
if [ "$number" = 0 ]; then
  printf 'no defect\nnone\n'
else
  applied=$("$here/apply.sh" "$number" "$work/mutant") || exit 2
  file=${applied##*$'\n'}
  for source in "$work"/mutant/src/*.c; do
    if [ "src/$(basename "$source")" = "$file" ] || grep -q "\"$(basename "$file")\"" "$source" ||
      { [ "$file" = src/nibble.h ] && grep -q p01_packet.h "$source"; }; then
      compile "$source" "$work/mutant" || exit 2
    fi
  done
  printf '%s\n' "$applied"
fi
"${CC:-cc}" -shared -Wl,-soname,"$soname" "$work"/mutant/*.o -o "$work/lib/$soname" || exit 2
ln -s "$soname" "$work/lib/libe2e.so"
