#!/usr/bin/env bash
# Runs every test stage, prints the time of each, and ends with the line "N passed, N failed".
#
#   scripts/test.sh [STAGE...]      without names: all
#
# Exit status 1 when anything failed or a stage ran nothing. Logs and JUnit files: _build/reports/test/.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 2
root=$PWD

# name and command, in the order they run
stages=(
  "build:scripts/stages/build.sh"
  "c:scripts/stages/native.sh release"
  "erlang:scripts/stages/erlang.sh"
  "properties:scripts/stages/properties.sh"
  "programs:scripts/stages/scripts.sh"
  "machines:scripts/stages/machines.sh"
  "sanitizers:scripts/stages/native.sh asan"
  "threads:scripts/stages/native.sh tsan"
  "embedded:scripts/stages/embedded.sh"
  "dialyzer:scripts/stages/dialyzer.sh"
  "format:scripts/stages/format.sh"
  "lint:scripts/stages/lint.sh"
  "docs:scripts/stages/docs.sh"
  "visualizer:scripts/stages/visualizer.sh"
  "browser:scripts/stages/browser.sh"
  "fuzz:scripts/stages/fuzz.sh"
)
wanted=("$@")
selected() {
  [ ${#wanted[@]} -eq 0 ] && return 0
  local name
  for name in "${wanted[@]}"; do [ "$name" = "$1" ] && return 0; done
  return 1
}
for name in "${wanted[@]}"; do
  [[ " ${stages[*]}" = *" $name:"* ]] || { echo "test: no stage '$name'" >&2; exit 2; }
done

passed=0
failed=0
result="$root/_build/reports/test/result"
mkdir -p "$(dirname "$result")"
started=$SECONDS
for stage in "${stages[@]}"; do
  name=${stage%%:*}
  selected "$name" || continue
  read -r -a command <<<"${stage#*:}"
  rm -f "$result"
  before=$SECONDS
  FC_RESULT=$result "${command[@]}" </dev/null
  good=0
  bad=0
  if [ -s "$result" ]; then read -r good bad <"$result"; fi
  if [ $((good + bad)) -eq 0 ]; then
    echo "stage $name ran nothing"
    bad=1
  fi
  printf 'stage %-10s %4d passed %3d failed %4d s\n' "$name" "$good" "$bad" $((SECONDS - before))
  passed=$((passed + good))
  failed=$((failed + bad))
done
rm -f "$result"
echo "all stages took $((SECONDS - started)) s"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
