#!/usr/bin/env bash
# Does what docs/tutorial.md says, in an empty folder (see test/walk.sh).
#
#   test/tutorial_test.sh [BIN]       BIN: the folder of the program (default: bin/ of this clone)
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
bin=$(cd "${1:-$root/bin}" && pwd)
here=$(mktemp -d "${TMPDIR:-/tmp}/faultcheck-tutorial-XXXXXX")
trap 'rm -rf "$here"' EXIT
cd "$here" || exit 2
export PATH="$bin:$PATH"
unset FAULTCHECK_CASES
"$root/test/walk.sh" "$root/docs/tutorial.md"
