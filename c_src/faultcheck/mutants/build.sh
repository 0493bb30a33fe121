#!/usr/bin/env bash
# Builds libfaultcheck with one seeded defect: only what depends on the changed file is compiled anew.
#
#   build.sh NUMBER DIRECTORY    NUMBER 0: no defect. Writes DIRECTORY/lib/libfaultcheck.so, the driver
#                                libfc_threads.so and the embedded profile, libfi_model.so, and keeps what can be used
#                                again
#
# Prints what is wrong and in which file, one line each. The compiler is $CXX, or c++. Exit status 2 when the defect
# does not exist or does not compile.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
[ $# -eq 2 ] || { echo "usage: build.sh NUMBER DIRECTORY" >&2; exit 2; }
number=$1
mkdir -p "$2"
work=$(cd "$2" && pwd)
soname=libfaultcheck.so.$(cut -d . -f 1 "$here/../../../VERSION")
flags=(-std=c++17 -O1 -g -w -fPIC -fvisibility=hidden -ffp-contract=off -I "$here/../include")

compile() { # SOURCE DIRECTORY
  "${CXX:-c++}" "${flags[@]}" -MMD -c "$1" -o "$2/$(basename "$1" .cpp).o"
}

if [ ! -f "$work/good/done" ]; then
  mkdir -p "$work/good"
  for source in "$here"/../src/*.cpp; do compile "$source" "$work/good" || exit 2; done
  touch "$work/good/done"
fi

rm -rf "${work:?}/mutant" "${work:?}/lib"
mkdir -p "$work/mutant" "$work/lib"
cp "$work"/good/*.o "$work/mutant/"
embedded="$here/../embedded"
if [ "$number" = 0 ]; then
  printf 'no defect\nnone\n'
else
  applied=$("$here/apply.sh" "$number" "$work/mutant") || exit 2
  file=$(basename "${applied##*$'\n'}")
  embedded="$work/mutant/embedded"
  for source in "$work"/mutant/src/*.cpp; do
    if grep -q "/$file\b" "$work/good/$(basename "$source" .cpp).d"; then
      compile "$source" "$work/mutant" || exit 2
    fi
  done
  printf '%s\n' "$applied"
fi
"${CXX:-c++}" -shared -pthread -Wl,-soname,"$soname" "-Wl,--version-script=$here/../src/exports.map" \
  "$work"/mutant/*.o -o "$work/lib/$soname" || exit 2
ln -s "$soname" "$work/lib/libfaultcheck.so"
"${CC:-cc}" -std=c99 -O1 -g -fPIC -shared -pthread -fvisibility=hidden -I "$here/../include" -I "$here/../threads" \
  "$here/../threads/fc_threads.c" -o "$work/lib/libfc_threads.so" -L "$work/lib" -lfaultcheck \
  "-Wl,-rpath,\$ORIGIN" || exit 2
"${CC:-cc}" -std=c99 -O1 -g -w -ffreestanding -ffp-contract=off -fPIC -shared -I "$embedded" "$embedded/fi.c" \
  "$here/../embedded/test/fi_replies.c" -o "$work/lib/libfi_model.so"
