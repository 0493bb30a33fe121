#!/usr/bin/env bash
# C line coverage of the airbag and its E2E library, one lcov HTML report for each fault class of the paper's figures.
#
# The runs are airbag_coverage's: classes/0 names the fault classes, run(Class, Library, StatusFile) makes the tests of
# one class with the library given, flushes its counters and appends the class's row to the table of E2E statuses.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
build="$root/_build/cmake/coverage"
reports="$root/_build/reports/coverage"

scripts/build_native.sh release >/dev/null
scripts/build_native.sh coverage >/dev/null
rebar3 compile >/dev/null
rm -rf "$reports"
mkdir -p "$reports"

erlang() { # erlang EXPRESSION: in a VM with every application; an error is one line and exit status 1
  ERL_LIBS="$root/_build/default/lib" erl -noinput -eval "
    try $1, halt(0) catch _:R -> io:format(standard_error, \"coverage: ~0p~n\", [R]), halt(1) end."
}

# lcov 2 stops where lcov 1 only warned; what may differ between gcc versions is not an error here.
tolerant=()
case "$(lcov --version)" in *version\ 2*) tolerant=(--ignore-errors "mismatch,unused,empty,inconsistent") ;; esac

report() { # report CLASS: counters of the last run -> HTML
  local info="$reports/$1.info"
  lcov_and_genhtml "$1" "$info" 2>"$reports/lcov.log" || { cat "$reports/lcov.log" >&2; exit 1; }
  awk -F: -v class="$1" '/^LF:/ {all += $2} /^LH:/ {hit += $2}
    END {printf "%-24s %4d of %4d lines (%.1f %%)\n", class, hit, all, 100 * hit / all}' "$info"
}

# What an airbag test runs: the application, and profile 1 with its checksum.
sources=("$root/c_src/airbag/src/airbag.c" "$root/c_src/e2e/src/p01.c" "$root/c_src/e2e/src/crc8.c")

lcov_and_genhtml() {
  local info=$2 branches=(--rc lcov_branch_coverage=1)
  lcov -q "${tolerant[@]}" "${branches[@]}" --capture --directory "$build" --base-directory "$root/c_src" \
    --output-file "$info.all" &&
    lcov -q "${tolerant[@]}" "${branches[@]}" --extract "$info.all" "${sources[@]}" --output-file "$info" &&
    rm "$info.all" &&
    genhtml -q "${tolerant[@]}" --branch-coverage --legend --title "airbag, $1" --prefix "$root/c_src" \
      --output-directory "$reports/$1" "$info"
}

for class in $(erlang 'io:format("~s", [lists:join(" ", [atom_to_list(C) || C <- airbag_coverage:classes()])])'); do
  find "$build" -name '*.gcda' -delete
  erlang "airbag_coverage:run('$class', \"$build/out/lib/libairbag.so\", \"$reports/status.md\")" >"$reports/$class.log"
  report "$class"
  echo "  $reports/$class/index.html"
done
echo
cat "$reports/status.md"
