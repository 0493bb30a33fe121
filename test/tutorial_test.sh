#!/usr/bin/env bash
# Does what docs/tutorial.md says, in an empty folder: writes its files, types its commands, compares what they print.
# A line "..." of the tutorial stands for any lines, "..." within a line for any text.
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

# fits EXPECTED OUTPUT: every line that is expected comes, in order; without "..." between them, one behind the other
fits() {
  awk -v expected="$1" -v said="$2" '
    function like(pattern, line) {  # "..." stands for any text
      gsub(/[][(){}.*+?^$|\\]/, "\\\\&", pattern)
      gsub(/\\\.\\\.\\\./, ".*", pattern)
      return line ~ ("^" pattern "$")
    }
    BEGIN {
      n = split(expected, want, "\n"); m = split(said, got, "\n"); j = 1; gap = 0
      for (i = 1; i <= n; i++) {
        if (want[i] == "...") { gap = 1; continue }
        while (gap && j <= m && !like(want[i], got[j])) j++
        if (j > m || !like(want[i], got[j])) { print "missing: " want[i]; exit 1 }
        j++; gap = 0
      }
      if (!gap && n > 0 && j <= m) { print "not in the tutorial: " got[j]; exit 1 }
    }'
}

failures=0
# try COMMAND EXPECTED: types a command in the folder that the ones before have chosen
try() {
  local output why
  case "$1" in cd\ *) cd "${1#cd }" || exit 2 ;; esac
  output=$(bash -c "$1" 2>&1 </dev/null)
  if [[ $1 == cd\ * ]] || why=$(fits "$2" "$output"); then
    echo "ok $1"
  else
    printf 'not ok %s\n    %s\n' "$1" "$why"
    sed 's/^/    | /' <<<"$output"
    failures=$((failures + 1))
  fi
}

kind='' file='' text='' command='' expected=''
flush() { [ -z "$command" ] || try "$command" "${expected%$'\n'}"; command='' expected=''; }
while IFS= read -r line; do
  case "$kind:$line" in
    :\`\`\`console) kind=console ;;
    :\`\`\`*\ *) kind=file file=${line#* } text='' ;;
    console:\`\`\`) kind='' && flush ;;
    console:\$\ *) flush; command=${line#\$ } ;;
    console:*) expected+=$line$'\n' ;;
    file:\`\`\`) kind='' && printf '%s' "$text" >"$file" ;;
    file:*) text+=$line$'\n' ;;
  esac
done <"$root/docs/tutorial.md"
[ $failures -eq 0 ]
