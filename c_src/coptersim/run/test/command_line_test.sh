#!/usr/bin/env bash
# coptersim_run as a user meets it: command_line_test.sh COPTERSIM_RUN EXAMPLES
#
# Exit status, what is on standard output, and that an error is one line that names file, line and reason.
set -uo pipefail
run=$1
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
says() { grep -q -E -- "$1" "$work/$2" || fail "no \"$1\" in $2: $(head -c 600 "$work/$2")"; }

hover="$examples/hover.json"
collision="$examples/lost_messages.json"

# What the examples say happens.
expect 0 "$run" --fail-on-collision "$hover"
says '"collision":null' out
says '"end_t_us":10000000' out
expect 0 "$run" --fail-on-collision "$examples/crossing.json"
says '"collision":null' out
says '"override_steps":[1-9]' out
expect 3 "$run" --fail-on-collision "$collision"
says '"collision":\{"t_us":[0-9]+,"kind":"copter","ids":\[0,1\]' out
expect 0 "$run" "$collision"
expect 3 "$run" --fail-on-collision "$examples/reflection.json"
says '"kind":"terrain","ids":\[0\]' out

# Output.
expect 0 "$run" --format csv "$collision"
head -n 1 "$work/out" | grep -q '^t_us,copter,true_px,.*,perceived_yaw,override$' || fail "head of the csv"
says '^# collision t_us=[0-9]+ kind=copter ids=0,1 point=' out
[ "$(sed -n 2p "$work/out" | tr ',' '\n' | wc -l)" -eq 17 ] || fail "columns of the csv"
expect 0 "$run" "$hover"
cp "$work/out" "$work/trace"
for options in "--threads 4" "--replay --speed 0" "--replay --speed 0 --part-ms 1" "--out $work/file"; do
  # shellcheck disable=SC2086 # words
  expect 0 "$run" $options "$hover"
  if [ -f "$work/file" ]; then mv "$work/file" "$work/out"; fi
  cmp "$work/out" "$work/trace" || fail "another trace with $options"
done
refused "standard input:1: not JSON" "$run" -
expect 0 "$run" --help
says '--bisect NAME=LOW:HIGH' out

# Replay tells events and the end.
expect 0 "$run" --replay --speed 1000 "$collision"
says ' 0\.500 s  copter 0: roll 0\.3' err
says 'fault drop on ITS_DATA0' err
says 'collision of copters 0 and 1 at' err

# Overrides and the search for the smallest value that survives.
expect 0 "$run" --set halt_on_collision=false --set record_every_us=1000000 "$collision"
says '"end_t_us":8000000' out
says '"t_us":\[0,1000000,2000000,3000000,' out
expect 0 "$run" --bisect comfort_radius=0:2 "$examples/crossing.json"
says '^smallest comfort_radius without a collision: ' out
expect 1 "$run" --bisect comfort_radius=0:2 "$collision"
says '^every value of comfort_radius that was tried from 0 to 2 has a collision$' out
refused '--bisect .*nothing' "$run" --bisect nothing=0:1 "$hover"

# Wrong command lines.
refused 'a scenario expected' "$run"
refused 'unknown option --nothing' "$run" --nothing "$hover"
refused 'one scenario expected' "$run" "$hover" "$hover"
refused '--threads: a whole number from 1 to 64 expected' "$run" --threads 0 "$hover"
refused '--format: json or csv expected' "$run" --format=xml "$hover"
refused '--speed: a number' "$run" --replay --speed -1 "$hover"
refused '--set pos_q: unknown parameter' "$run" --set pos_q=1 "$hover"
refused 'build' "$run" --build z80 "$hover"
refused 'cannot be read' "$run" "$work/nowhere.json"
refused 'cannot be read' "$run" "$work"
refused 'No such file' "$run" --out "$work/no/folder" "$hover"
refused 'standard output: No space left' sh -c '"$0" "$1" >/dev/full' "$run" "$hover"

# Wrong scenarios.
refused_text() {
  local pattern=$1
  printf '%s' "$2" >"$work/bad.json"
  refused "bad\.json:$pattern" "$run" "$work/bad.json"
  refused "bad\.json:$pattern" "$run" --out "$work/no_trace" "$work/bad.json"
  [ -e "$work/no_trace" ] && fail "a partial trace of: $2"
}
head='{"format":"coptersim-scenario/1","dt_us":5000,"duration_us":1000000,'
refused_text '1: not JSON' 'no scenario'
refused_text '1: not JSON' "$(head -c 300 "$hover" | tr -d '\n')"
refused_text '2: copters\[1\]\.id: ' "$head\"copters\":[{\"id\":0,\"pos\":[0,0]},
{\"id\":-1,\"pos\":[0,0]}]}"
refused_text '1: copters: the id 0 is there twice' \
  "$head\"copters\":[{\"id\":0,\"pos\":[0,0]},{\"id\":0,\"pos\":[9,0]}]}"
refused_text '1: .*unknown; known here' "$head\"copters\":[],\"colour\":1}"
fault='"type":"packet_fault","channel":"ITS_DATA0","model":'
refused_text '2: events\[0\]: either delay_us and duration_us, or from_calls and for_calls' \
  "$head\"copters\":[],\"events\":[
{\"t_us\":0,$fault\"lose\",\"delay_us\":5000,\"for_calls\":1}]}"
refused_text '2: events\[0\]\.params\.count: 10000 are the most' "$head\"copters\":[],\"events\":[
{\"t_us\":0,$fault\"repeat\",\"params\":{\"count\":10001}}]}"
head -c 4000 "$run" >"$work/binary"
refused 'binary:1: not JSON' "$run" "$work/binary"
truncate -s 300M "$work/huge.json"
refused 'huge\.json: larger than 256 MiB' "$run" "$work/huge.json"

# An interrupted replay ends with status 130 and without a trace.
mkfifo "$work/progress"
"$run" --replay --speed 0.01 "$hover" >"$work/out" 2>"$work/progress" &
pid=$!
head -n 1 "$work/progress" >/dev/null
kill -INT $pid
wait $pid
status=$?
[ $status -eq 130 ] || fail "status $status after an interrupt"
[ -s "$work/out" ] && fail "a trace after an interrupt"

[ $failures -eq 0 ] && echo "all as expected"
exit $((failures > 0))
