#!/usr/bin/env bash
# Formatting of every tracked source file: clang-format for C and C++, blanks and line length for the rest.
source "$(dirname "$0")/lib.sh"

mapfile -t c_files < <(git ls-files '*.c' '*.h' '*.cpp' '*.hpp' | grep -v -E '(^|/)(vendor|generated)/')
# Versions of clang-format break a few lines differently; the sources are those of version 14 (Debian 12).
version=$(clang-format --version | sed 's/.*version \([0-9]*\).*/\1/')
if [ "$version" = 14 ]; then
  for file in "${c_files[@]}"; do
    [ -f "$file" ] && check "format of $file (make format)" clang-format --dry-run -Werror "$file"
  done
else
  echo "clang-format $version is not the version that C and C++ are formatted with (14): not compared" >&2
fi

# Erlang and scripts: no tabs, no trailing blanks, lines of at most 100 characters (scripts: 120), a newline at the end.
blanks() {
  awk -v max="$2" -v file="$1" '
    /\t/          { print file ":" FNR ": tab"; bad = 1 }
    /[ \t\r]$/    { print file ":" FNR ": blank at the end of the line"; bad = 1 }
    length > max  { print file ":" FNR ": " length " characters, at most " max; bad = 1 }
    END           { exit bad }' "$1" && [ -z "$(tail -c 1 "$1")" ]
}
while read -r file; do [ -f "$file" ] && check "layout of $file" blanks "$file" 100; done \
  < <(git ls-files '*.erl' '*.hrl' '*.app.src' 'rebar.config*')
while read -r file; do [ -f "$file" ] && check "layout of $file" blanks "$file" 120; done \
  < <(git ls-files '*.sh' '.ci/run' '*.cmake' '*CMakeLists.txt')
finish
