#!/usr/bin/env bash
# Does what examples/README.md says, in a copy of the examples, against an installed FaultCheck (see test/walk.sh).
# Then the program written for the original headers: unchanged, as C and as C++.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
here=$(mktemp -d "${TMPDIR:-/tmp}/faultcheck-examples-XXXXXX")
trap 'rm -rf "$here"' EXIT
unset FAULTCHECK_CASES

export PREFIX="$here/prefix"
"$root/scripts/install.sh" "$PREFIX" >"$here/install.log" 2>&1 || { cat "$here/install.log"; exit 1; }
export PATH="$PREFIX/bin:$PATH" PKG_CONFIG_PATH="$PREFIX/lib/pkgconfig" LD_LIBRARY_PATH="$PREFIX/lib"
mkdir "$here/examples"
(cd "$root/examples" && git ls-files -z | xargs -0 cp --parents -t "$here/examples")
cd "$here/examples" || exit 2
status=0
"$root/test/walk.sh" README.md || status=1

# original STANDARD COMPILER LANGUAGE
original() {
  local output
  # shellcheck disable=SC2046 # words
  if output=$("$2" "-std=$1" -Wall -Wextra -pedantic -Werror -x "$3" "$root/test/compat/original_program.c" -x none \
    $(pkg-config --cflags --libs faultcheck) -lm -o "$here/original" 2>&1 && "$here/original" 2>&1); then
    echo "ok a program written for the original headers, as $1"
  else
    printf 'not ok a program written for the original headers, as %s\n%s\n' "$1" "$output"
    status=1
  fi
}
original c99 gcc c
original c++17 g++ c++
exit $status
