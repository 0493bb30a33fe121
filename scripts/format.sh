#!/usr/bin/env bash
# Formats every tracked C and C++ file in place.
set -euo pipefail
cd "$(dirname "$0")/.."
git ls-files '*.c' '*.h' '*.cpp' '*.hpp' | grep -v -E '(^|/)(vendor|generated)/' | xargs -r clang-format -i
