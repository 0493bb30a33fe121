#!/usr/bin/env bash
# The browser tests of the visualizer (visualizer/test/): a real Chromium, the real bridge, real packets, where the only
# network interface is the loopback.
source "$(dirname "$0")/lib.sh"
log="$reports/browser.log"

scripts/build_visualizer.sh test >"$log" 2>&1 || {
  tail -n 20 "$log"
  echo "the visualizer was not built"
  finish 1
}
rm -f "$reports/browser.xml"
(cd visualizer && timeout --kill-after=10 1800 ../scripts/loopback.sh npx vitest run --config test/vitest.config.ts \
  --reporter=default --reporter=junit --outputFile.junit="$reports/browser.xml") >>"$log" 2>&1
status=$?
[ $status -eq 0 ] || tail -n 60 "$log" | plain
if [ -f "$reports/browser.xml" ]; then count_junit "$reports/browser.xml"; fi
finish $status
