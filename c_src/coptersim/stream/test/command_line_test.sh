#!/usr/bin/env bash
# coptersim_stream as a user meets it: command_line_test.sh COPTERSIM_STREAM EXAMPLES
#
# Nothing is published here: test/lcm_test.sh does that, in a network namespace.
set -uo pipefail
stream=$1
examples=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0
fail() {
  echo "FAILED: $*" >&2
  failures=$((failures + 1))
}

# expect STATUS COMMAND...: output in $work/out and $work/err
expect() {
  local status=$1 got=0
  shift
  "$@" >"$work/out" 2>"$work/err" </dev/null || got=$?
  [ "$got" -eq "$status" ] || fail "status $got, not $status: $* ($(head -n 3 "$work/err"))"
}
# refused PATTERN COMMAND...: status 2, nothing on standard output, one line that matches
refused() {
  local pattern=$1
  shift
  expect 2 "$@"
  [ -s "$work/out" ] && fail "output in spite of an error: $*"
  [ "$(wc -l <"$work/err")" -eq 1 ] || fail "not one line of error: $*: $(cat "$work/err")"
  grep -q -E -- "$pattern" "$work/err" || fail "no \"$pattern\" in: $(cat "$work/err")"
}
says() { grep -q -E -- "$1" "$work/out" || fail "no \"$1\" in: $(head -c 600 "$work/out")"; }
hover=$examples/hover.json

expect 0 "$stream" --help
says 'Exit status: 0 done'
refused 'a scenario expected; see coptersim_stream --help' "$stream"
refused 'unknown option --what' "$stream" --what "$hover"
refused 'one scenario expected, not also' "$stream" "$hover" "$hover"
refused '--log: a value expected' "$stream" "$hover" --log
refused '--speed: 0 or a number from 0.05 to 1000 expected' "$stream" --speed 0.01 "$hover"
refused '--speed: 0 or' "$stream" --speed nan "$hover"
refused '--observer: the id of a copter expected' "$stream" --observer 1.5 "$hover"
refused '--observer: the id' "$stream" --observer=-1 "$hover"
refused 'udpm://GROUP:PORT\?ttl=0 expected' "$stream" --lcm-url=file:///x "$hover"
refused 'ttl=1 lets packets leave this host; use ttl=0' "$stream" '--lcm-url=udpm://239.255.76.67:7667?ttl=1' "$hover"
refused 'nowhere.json: ' "$stream" --log "$work/x.lcm" nowhere.json
refused '--set ' "$stream" --log "$work/x.lcm" --set pos_p=x "$hover"
refused '/nowhere/x.lcm: No such file or directory' "$stream" --log /nowhere/x.lcm "$hover"
refused '/dev/full: No space left on device' "$stream" --log /dev/full "$hover"

# The same bytes each time; how it ends.
expect 0 "$stream" --log "$work/a.lcm" "$examples/lost_messages.json"
says '^lost_messages: copters 0 and 1 collided at 3.015000 s'
expect 0 "$stream" --log "$work/b.lcm" "$examples/lost_messages.json"
cmp -s "$work/a.lcm" "$work/b.lcm" || fail "two logs of one flight differ"
expect 0 "$stream" --log "$work/c.lcm" --observer 1 "$examples/lost_messages.json"
cmp -s "$work/a.lcm" "$work/c.lcm" && fail "another observer changes nothing"
"$stream" --log /dev/stdout --set duration_us=100000 "$hover" | cat >"$work/out"
[ -L /dev/stdout ] || fail "/dev/stdout has been replaced"
[ "$(head -c 4 "$work/out" | od -An -tx1)" = ' ed a1 da 01' ] || fail "a log to a pipe does not begin as one"

# An interrupt leaves nothing behind: a long flight, told once its file is there.
long=(--log "$work/long.lcm" --set duration_us=36000000000 "$hover")
"$stream" "${long[@]}" >"$work/out" 2>"$work/err" &
child=$!
deadline=$((SECONDS + 20))
until compgen -G "$work/long.lcm.part.*" >/dev/null || [ $SECONDS -ge $deadline ]; do sleep 0.01; done
kill -INT "$child"
got=0
wait "$child" || got=$?
[ "$got" -eq 130 ] || fail "status $got, not 130, after an interrupt: $(cat "$work/err")"
compgen -G "$work/long.lcm*" >/dev/null && fail "an interrupted flight leaves $(ls "$work")"
[ $failures -eq 0 ]
