#!/usr/bin/env bash
# Runs each fuzz target for the given number of seconds and prints what came of it.
set -euo pipefail
case "${1:-}" in
  '' | *[!0-9]*) echo "fuzz: FUZZ_SECONDS must be a whole number of seconds, not '${1:-}'" >&2; exit 2 ;;
esac
FUZZ_SECONDS=$1 exec "$(dirname "$0")/test.sh" fuzz
