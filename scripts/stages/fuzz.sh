#!/usr/bin/env bash
# A short run of every fuzz target; a target passes when it finds nothing. FUZZ_SECONDS is the time for each, or
# FUZZ_RUNS the number of its runs. Prints how many runs there were.
source "$(dirname "$0")/lib.sh"
limit="-max_total_time=${FUZZ_SECONDS:-10}"
[ -z "${FUZZ_RUNS:-}" ] || limit="-runs=$FUZZ_RUNS"

scripts/build_native.sh fuzz >"$reports/build-fuzz.log" 2>&1 || {
  tail -n 40 "$reports/build-fuzz.log"
  echo "the fuzz build failed"
  finish 1
}
shopt -s nullglob

# One target; its log stays in _build/fuzz.
fuzz() { # NAME TARGET ARGUMENT...
  local name=$1 log="_build/fuzz/$1.log"
  shift
  if ! "$@" >"$log" 2>&1; then
    tail -n 20 "$log"
    return 1
  fi
  sed -nE "s/^Done ([0-9]+) runs in ([0-9]+) second.*/$name: \\1 runs in \\2 s/p" "$log" >&3
}

for target in _build/cmake/fuzz/out/bin/fuzz_*; do
  name=$(basename "$target")
  corpus="_build/fuzz/$name"
  mkdir -p "$corpus"
  seeds=(c_src/*/fuzz/corpus/"${name#fuzz_}" c_src/*/*/fuzz/corpus/"${name#fuzz_}")
  check "$name" fuzz "$name" "$target" "$limit" -timeout=10 -rss_limit_mb=2048 \
    -artifact_prefix="_build/fuzz/$name-" "$corpus" "${seeds[@]}" 3>&1
done

# The readers of the page and the bridge (visualizer/fuzz/targets.ts); they have no instrumentation, so 3 s each are
# enough unless more is asked for.
if check "fuzz targets of the visualizer build" scripts/build_visualizer.sh fuzz; then
  for target in packet fragments log message protocol; do
    check "viz_$target" fuzz "viz_$target" \
      node _build/visualizer/fuzz.mjs "$target" "${FUZZ_SECONDS:-3}" "${FUZZ_RUNS:-}" 3>&1
  done
fi

# The same readers in Erlang, no instrumentation either.
lcm_fuzz() {
  ERL_LIBS=_build/default/lib apps/replay/fuzz/replay_fuzz.escript "$1" "${FUZZ_SECONDS:-3}" "${FUZZ_RUNS:-}"
}
if check "the Erlang side builds" rebar3 compile; then
  for target in message packet fragments log; do
    check "lcm_$target" fuzz "lcm_$target" lcm_fuzz "$target" 3>&1
  done
fi
finish
