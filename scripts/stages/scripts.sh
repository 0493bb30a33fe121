#!/usr/bin/env bash
# Whole-program tests: every test/*_test.sh is one that prints "ok NAME" or "not ok NAME" for each thing it checks.
source "$(dirname "$0")/lib.sh"
status=0
while read -r file; do
  log="$reports/$(basename "$file" .sh).log"
  "$file" >"$log" 2>&1 || { status=1; echo "$file failed:"; tail -n 30 "$log"; }
  good=$(grep -c '^ok ' "$log")
  bad=$(grep -c '^not ok ' "$log")
  passed=$((passed + good))
  failed=$((failed + bad))
  if [ $((good + bad)) -eq 0 ]; then
    echo "$file checked nothing"
    failed=$((failed + 1))
  fi
done < <(git ls-files 'test/*_test.sh')
finish $status
