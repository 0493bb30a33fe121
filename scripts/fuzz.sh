#!/usr/bin/env bash
# Runs each fuzz target and prints what came of it: fuzz.sh SECONDS [RUNS]. With RUNS each is run that often, however
# long it takes.
set -euo pipefail
whole() { # NAME VALUE
  case "$2" in
    '' | *[!0-9]*) echo "fuzz: $1 must be a whole number, not '$2'" >&2; exit 2 ;;
  esac
}
whole FUZZ_SECONDS "${1:-}"
if [ -n "${2:-}" ]; then whole FUZZ_RUNS "$2"; fi
FUZZ_SECONDS=$1 FUZZ_RUNS=${2:-} exec "$(dirname "$0")/test.sh" fuzz
