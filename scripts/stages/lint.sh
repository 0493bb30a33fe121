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
  include=$(dirname "$header")
  includes=(-I "$include" -I c_src/faultcheck/include -I c_src/e2e/include)
  strict=(-Wall -Wextra -pedantic -Werror -fsyntax-only "${includes[@]}")
  check "$header as C99" gcc -std=c99 "${strict[@]}" -include "$header" -x c "$nothing"
  check "$header as C++17" g++ -std=c++17 "${strict[@]}" -include "$header" -x c++ "$nothing"
done < <(git ls-files 'c_src/*/include/*.h' 'c_src/*/include/**/*.h' c_src/faultcheck/embedded/fi.h)

# What documents and comments refer to is there: links, and `docs/...` and the like.
missing() { # missing FILE: prints what FILE names in vain
  local name status=0
  while read -r name; do
    [ -e "$(dirname "$1")/$name" ] || { echo "$1: no $name"; status=1; }
  done < <(grep -oE '\]\([A-Za-z./][^)#: ]*\)' "$1" | tr -d '()' | sed 's/^]//')
  while read -r name; do
    [ -e "$name" ] || { echo "$1: no $name"; status=1; }
  done < <(grep -oE '`(docs|scripts|bench|examples|bin)/[A-Za-z0-9_./-]*[A-Za-z0-9_/]`' "$1" | tr -d '`')
  return $status
}
while read -r file; do check "references of $file" missing "$file"; done < <(git ls-files '*.md')
while read -r page; do
  check "$page, named in comments, is there" test -f "$page"
done < <(git grep -ohE 'docs/[a-z0-9_]+\.md' -- '*.c' '*.h' '*.cpp' '*.hpp' '*.erl' '*.hrl' '*.sh' | sort -u)

check "rebar3 xref" rebar3 xref
finish
