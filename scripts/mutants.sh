#!/usr/bin/env bash
# Shows which seeded defects the PropEr models find, and how fast: _build/reports/mutants.md.
#
#   scripts/mutants.sh [LIBRARY...]      without names: each library of c_src/ that has mutants/build.sh
#
# Of a library's folder c_src/LIBRARY/mutants it uses
#   apply.sh --numbers      the numbers of all defects
#   build.sh NUMBER DIR     writes DIR/lib/libLIBRARY.so; prints what is wrong and in which file
#   properties.txt          property modules (files), which find the library in FAULTCHECK_LIB_DIR
#   survivors.txt           "NUMBER why the models cannot see it", where there are any
# and, if there is e2e_mutants or the like among its CTests, `scripts/mutants.sh c-tests` runs these.
# Exit status 1 when a defect survives without an explanation.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 2
root=$PWD
report="$root/_build/reports/mutants.md"
seconds_each=300

if [ "${1:-}" = c-tests ]; then
  scripts/build_native.sh release
  exec cmake --build _build/cmake/release --target mutants
fi

if [ $# -eq 0 ]; then
  for folder in c_src/*/mutants/build.sh; do
    folder=${folder#c_src/}
    set -- "$@" "${folder%%/*}"
  done
fi
rebar3 compile >/dev/null || exit 3
mkdir -p "$(dirname "$report")" _build/mutants/ebin
export ERL_LIBS="$root/_build/default/lib"
printf '# Seeded defects and the PropEr models\n' >"$report"

# One run of all properties: sets status and verdict.
hunt() { # DIRECTORY MODULE...
  local work=$1
  shift
  verdict=$(FAULTCHECK_LIB_DIR="$work/lib" timeout "$seconds_each" \
    erl -noinput -pa _build/mutants/ebin -run e2e_mutants main "$@" 2>"$work/output")
  status=$?
  # A defect may print, too; the verdict is the last line.
  verdict=${verdict##*$'\n'}
}

unexplained=0
one_library() { # LIBRARY
  local library=$1 here="c_src/$1/mutants" work="$root/_build/mutants/$1"
  local modules=() file number built title how property tests seconds sound_seconds killed=0 total=0
  [ -x "$here/build.sh" ] || { echo "mutants: $here/build.sh is missing" >&2; exit 2; }
  rm -rf "$work"
  mkdir -p "$work"
  while read -r file; do
    erlc -I apps -o _build/mutants/ebin "$file" || exit 3
    modules+=("$(basename "$file" .erl)")
  done < <(grep -v '^#' "$here/properties.txt")

  "$here/build.sh" 0 "$work" >/dev/null || exit 3
  hunt "$work" "${modules[@]}"
  [ "$status" -eq 1 ] || {
    echo "mutants: the properties of $library fail without a defect: $verdict" >&2
    cat "$work/output" >&2
    exit 3
  }
  sound_seconds=$(cut -d '|' -f 4 <<<"$verdict")
  printf '\n## %s\n\nWithout a defect all properties pass: %s tests in %s s.\n\n' "$library" \
    "$(cut -d '|' -f 3 <<<"$verdict")" "$sound_seconds" >>"$report"
  printf '| | defect | killed by | tests | seconds |\n|---:|---|---|---:|---:|\n' >>"$report"

  for number in $("$here/apply.sh" --numbers); do
    built=$("$here/build.sh" "$number" "$work") || exit 3
    title=${built%%$'\n'*}
    total=$((total + 1))
    hunt "$work" "${modules[@]}"
    IFS='|' read -r how property tests seconds <<<"$verdict"
    case $status in
      0) ;;
      124)
        tests="" seconds=$seconds_each
        if [ "${sound_seconds%.*}" -lt $((seconds_each / 3)) ]; then
          how=killed property="tests that never end"
        else
          how=survived property="survived: not ended in time" unexplained=$((unexplained + 1))
        fi
        ;;
      1)
        how=survived
        property=$(sed -n "s/^$number //p" "$here/survivors.txt" 2>/dev/null)
        [ -n "$property" ] || { property="not explained" unexplained=$((unexplained + 1)); }
        property="survived: $property"
        ;;
      *) how=killed property="end of the VM, status $status" tests="" seconds="" ;;
    esac
    [ "$how" = killed ] && killed=$((killed + 1))
    printf '%3d %s: %s%s%s\n' "$number" "$title" "$property" "${tests:+, $tests tests}" "${seconds:+, $seconds s}"
    printf '| %d | %s | %s | %s | %s |\n' "$number" "$title" "$property" "$tests" "$seconds" >>"$report"
  done
  printf '%s: %d of %d defects killed\n' "$library" "$killed" "$total"
  printf '\n%d of %d defects killed.\n' "$killed" "$total" >>"$report"
}

for library in "$@"; do one_library "$library"; done
echo "written: _build/reports/mutants.md"
[ "$unexplained" -eq 0 ]
