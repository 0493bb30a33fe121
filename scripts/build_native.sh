#!/usr/bin/env bash
# Builds the C and C++ side (release) into _build/native and apps/c_bridge/priv. Incremental; CMake decides what is old.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
build="$root/_build/cmake/release"
generator=()
command -v ninja >/dev/null 2>&1 && generator=(-G Ninja)
[ -f "$build/CMakeCache.txt" ] || cmake -S "$root/c_src" -B "$build" "${generator[@]}" \
  -DCMAKE_BUILD_TYPE=Release -DFC_OUTPUT_DIR="$root/_build/native" >/dev/null
cmake --build "$build" --parallel "$(nproc)"
