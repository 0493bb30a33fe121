#!/usr/bin/env bash
# Runs every benchmark, writes _build/reports/bench.json and prints the table with the bounds of bench/bounds.
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

for program in _build/native/bin/*_bench bench/*_bench.escript; do
  [ -x "$program" ] || continue
  echo "running $(basename "$program")" >&2
  case "$program" in
    *.escript) ERL_LIBS="$root/_build/default/lib" escript "$program" >>"$lines" ;;
    *) taskset -c "$core" "$program" >>"$lines" ;;
  esac || { echo "bench: $program failed" >&2; exit 3; }
done

processor=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -1)
memory=$(awk '/MemTotal/ {printf "%.0f GiB", $2 / 1048576}' /proc/meminfo)
load=$(cut -d ' ' -f 1-3 /proc/loadavg)
{ printf '[\n'; grep '^ *{' "$lines" | sed '$!s/$/,/'; printf ']\n'; } >_build/reports/bench.json
echo "machine: $processor, $(nproc) cores, $memory, $(uname -sr); load now: $load"
status=0
awk -f bench/table.awk bench/bounds "$lines" || status=$?
echo "written: _build/reports/bench.json"
[ "${CHECK:-}" != 1 ] || exit $status
