#!/usr/bin/env bash
# Builds the C and C++ side, incrementally; CMake decides what is old.
#
#   scripts/build_native.sh [release|asan|tsan|fuzz|coverage|aarch64] [TARGET...]
#
# release (default) goes into _build/native and apps/c_bridge/priv; every other kind stays in _build/cmake/KIND.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
kind=${1:-release}
[ $# -gt 0 ] && shift
build="$root/_build/cmake/$kind"

command -v cmake >/dev/null 2>&1 || { echo "build_native: cmake is missing; run: make setup" >&2; exit 3; }

options=(-DFC_OUTPUT_DIR="$build/out" -DFC_PRIV_DIR="$build/priv" -DFC_BUILD_BENCH=OFF)
case "$kind" in
  release) options=(-DCMAKE_BUILD_TYPE=Release -DFC_OUTPUT_DIR="$root/_build/native") ;;
  asan) options+=(-DCMAKE_BUILD_TYPE=Debug "-DFC_SANITIZE=address;undefined") ;;
  tsan) options+=(-DCMAKE_BUILD_TYPE=Debug -DFC_SANITIZE=thread) ;;
  fuzz) options+=(-DCMAKE_BUILD_TYPE=Debug -DFC_FUZZ=ON
    -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DBUILD_TESTING=OFF) ;;
  coverage) options+=(-DCMAKE_BUILD_TYPE=Debug -DFC_COVERAGE=ON -DBUILD_TESTING=OFF) ;;
  aarch64) options+=(-DCMAKE_BUILD_TYPE=Release -DFC_BRIDGE=OFF -DBUILD_TESTING=OFF
    -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64
    -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++) ;;
  *) echo "build_native: unknown kind '$kind' (release, asan, tsan, fuzz, coverage or aarch64)" >&2; exit 2 ;;
esac

# Two builds in one tree at a time would write the same files.
mkdir -p "$build"
exec 9>"$build/.lock"
flock 9

if [ ! -f "$build/CMakeCache.txt" ]; then
  generator=()
  command -v ninja >/dev/null 2>&1 && generator=(-G Ninja)
  cmake -S "$root/c_src" -B "$build" "${generator[@]}" "${options[@]}" >"$build/configure.log" 2>&1 9>&- || {
    rm -f "$build/CMakeCache.txt"
    cat "$build/configure.log" >&2
    exit 3
  }
fi
targets=()
[ $# -gt 0 ] && targets=(--target "$@")
cmake --build "$build" --parallel "$(nproc)" "${targets[@]}" 9>&- | sed '/^ninja: no work to do\.$/d'
