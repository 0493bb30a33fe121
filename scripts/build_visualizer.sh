#!/usr/bin/env bash
# Builds the page and the bridge of the visualizer into visualizer/dist/ (npm run build), after fetching what that
# needs as visualizer/package-lock.json says. The same sources give the same bytes wherever they are.
#
#   scripts/build_visualizer.sh          as committed
#   scripts/build_visualizer.sh test     the page of the browser tests too: _build/visualizer/page.html
#   scripts/build_visualizer.sh fuzz     only the fuzz targets: _build/visualizer/fuzz.mjs
#   scripts/build_visualizer.sh fetch    only what `npm ci` fetches
set -euo pipefail
cd "$(dirname "$0")/../visualizer"

command -v npm >/dev/null 2>&1 || { echo "build_visualizer: npm is missing; run: scripts/setup.sh test" >&2; exit 2; }
# The lock file is the stamp: what it lists is fetched again only when it has changed.
if ! cmp -s package-lock.json node_modules/.fetched; then
  npm ci --no-fund --no-audit --loglevel=error
  cp package-lock.json node_modules/.fetched
fi
case "${1:-}" in
  '') npm run --silent build ;;
  test) npm run --silent build && npm run --silent build:test ;;
  fuzz) npm run --silent build:fuzz ;;
  fetch) ;;
  *) echo "build_visualizer: expected test, fuzz or fetch, got '$1'" >&2; exit 2 ;;
esac
