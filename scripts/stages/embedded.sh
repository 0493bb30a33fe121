#!/usr/bin/env bash
# The embedded profile on a microcontroller: it compiles, its size is printed and within bounds, it needs libgcc alone.
source "$(dirname "$0")/lib.sh"
log="$reports/embedded.log"
if scripts/embedded_size.sh >"$log" 2>&1; then passed=1; else failed=1; fi
cat "$log"
finish
