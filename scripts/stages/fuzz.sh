#!/usr/bin/env bash
# A short run of every fuzz target; a target passes when it finds nothing. FUZZ_SECONDS is the time for each.
source "$(dirname "$0")/lib.sh"
seconds=${FUZZ_SECONDS:-15}

scripts/build_native.sh fuzz >"$reports/build-fuzz.log" 2>&1 || {
  tail -n 40 "$reports/build-fuzz.log"
  echo "the fuzz build failed"
  finish 1
}
shopt -s nullglob
for target in _build/cmake/fuzz/out/bin/fuzz_*; do
  name=$(basename "$target")
  corpus="_build/fuzz/$name"
  mkdir -p "$corpus"
  seeds=(c_src/*/fuzz/corpus/"${name#fuzz_}" c_src/*/*/fuzz/corpus/"${name#fuzz_}")
  check "$name for $seconds s" "$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 \
    -artifact_prefix="_build/fuzz/$name-" "$corpus" "${seeds[@]}"
done
finish
