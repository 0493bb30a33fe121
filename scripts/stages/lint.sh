#!/usr/bin/env bash
# Static checks: shell scripts, public headers on their own as C99 and as C++17, cross references in Erlang.
source "$(dirname "$0")/lib.sh"

while read -r file; do
  check "shellcheck $file" shellcheck -S warning -x -P scripts/stages "$file"
done < <(git ls-files '*.sh' '.ci/run')

# A header is compiled as the only content of a source file that is otherwise this.
nothing="$reports/nothing.c"
echo 'typedef int not_empty;' >"$nothing"
while read -r header; do
  include=${header%%/include/*}/include
  includes=(-I "$include" -I c_src/faultcheck/include -I c_src/e2e/include)
  strict=(-Wall -Wextra -pedantic -Werror -fsyntax-only "${includes[@]}")
  check "$header as C99" gcc -std=c99 "${strict[@]}" -include "$header" -x c "$nothing"
  check "$header as C++17" g++ -std=c++17 "${strict[@]}" -include "$header" -x c++ "$nothing"
done < <(git ls-files 'c_src/*/include/*.h' 'c_src/*/include/**/*.h' c_src/faultcheck/embedded/fi.h)

check "rebar3 xref" rebar3 xref
finish
