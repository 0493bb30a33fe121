#!/usr/bin/env bash
# Does in the current folder what a document says: writes its files, types its commands, compares what they print, and
# prints "ok COMMAND" or "not ok COMMAND" for each.
#
#   test/walk.sh DOCUMENT
#
# A block that begins with ```console holds commands after "$ ", each followed by what it prints; a line "..." stands
# for any lines, "..." within a line for any text. A block that begins with ```LANGUAGE FILE is written to FILE.
set -uo pipefail
document=${1:?usage: test/walk.sh DOCUMENT}

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
      if (!gap && n > 0 && j <= m) { print "not in the document: " got[j]; exit 1 }
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
done <"$document"
[ $failures -eq 0 ]
