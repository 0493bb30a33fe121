#!/usr/bin/env bash
# Runs every benchmark, writes _build/reports/bench.json, and prints the table with the bounds of bench/bounds, which
# _build/reports/bench.md has too.
# Exit status 0, also when bounds are missed; with CHECK=1 a miss is exit status 1. See bench/README.md.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD

scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null

mkdir -p _build/reports
lines=$(mktemp)
trap 'rm -f "$lines"' EXIT
# The highest core: the lowest ones serve most interrupts.
core=$(($(nproc) - 1))

fail() { echo "bench: $1 failed" >&2; exit 3; }

for program in _build/native/bin/*_bench; do
  [ -x "$program" ] || continue
  echo "running $(basename "$program")" >&2
  taskset -c "$core" "$program" >>"$lines" || fail "$program"
done

export FC_ROOT="$root" ERL_LIBS="$root/_build/default/lib"
mkdir -p _build/bench
erlc -o _build/bench bench/*.erl
for source in bench/*_bench.erl; do
  module=$(basename "$source" .erl)
  echo "running $module" >&2
  taskset -c "$core" erl +S 1:1 -noinput -pa _build/bench -s "$module" main >>"$lines" || fail "$module"
done

echo "running the visualizer" >&2
visualizer_log=_build/bench/visualizer.log
scripts/build_visualizer.sh test >"$visualizer_log" 2>&1 || fail "building the visualizer ($visualizer_log)"
(cd visualizer && VIZ_BENCH_LINES="$lines" ../scripts/loopback.sh npx vitest run --config bench/vitest.config.ts) \
  >>"$visualizer_log" 2>&1 || fail "measuring the visualizer ($visualizer_log)"

processor=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -1)
memory=$(awk '/MemTotal/ {printf "%.0f GiB", $2 / 1048576}' /proc/meminfo)
load=$(cut -d ' ' -f 1-3 /proc/loadavg)
{ printf '[\n'; grep '^ *{' "$lines" | sed '$!s/$/,/'; printf ']\n'; } >_build/reports/bench.json
echo "machine: $processor, $(nproc) cores, $memory, $(uname -sr); load now: $load"
status=0
awk -f bench/table.awk bench/bounds "$lines" || status=$?
awk -v markdown=1 -f bench/table.awk bench/bounds "$lines" >_build/reports/bench.md || true
echo "written: _build/reports/bench.json and bench.md"
[ "${CHECK:-}" != 1 ] || exit $status
