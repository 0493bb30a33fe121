#!/usr/bin/env bash
# LCM between programs: coptersim_stream, lcm-logger, lcm-logplayer and the Erlang side hear one another, also when
# messages are fragmented; and nothing of it leaves the host. In network namespaces of their own.
set -uo pipefail
cd "$(dirname "$0")/.." || exit 2
root=$PWD

if [ "${1:-}" != inside ]; then
  scripts/build_native.sh release >/dev/null || exit 2
  rebar3 compile >/dev/null || exit 2
  output=$(scripts/loopback.sh true 2>&1) || { echo "not ok network namespaces: $output"; exit 1; }
  exec scripts/loopback.sh "$root/test/lcm_test.sh" inside
fi

bin=$root/_build/native/bin
tool=$root/test/lcm/tool.escript
export ERL_LIBS=$root/_build/default/lib
here=$(mktemp -d "${TMPDIR:-/tmp}/faultcheck-lcm-XXXXXX")
children=()
end_children() {
  local child
  for child in "${children[@]}"; do kill "$child" 2>/dev/null; done
  wait
  children=()
}
trap 'end_children; rm -rf "$here"' EXIT
url='udpm://239.255.76.67:7667?ttl=0&recv_buf_size=2097152'
failures=0

check() { # check TEXT COMMAND...: prints "ok TEXT" or "not ok TEXT" with the output
  local text=$1 output
  shift
  if output=$("$@" 2>&1); then
    echo "ok $text"
  else
    printf 'not ok %s\n%s\n' "$text" "$output"
    failures=$((failures + 1))
  fi
}
same() { [ "$1" = "$2" ] || { printf 'expected %s\nfound    %s\n' "$1" "$2"; return 1; }; }
await() { # await COMMAND...: until it succeeds, at most 20 s
  local deadline=$((SECONDS + 20))
  until "$@"; do
    [ $SECONDS -lt $deadline ] || { echo "timeout: $*"; return 1; }
    sleep 0.02
  done
}
listeners() { grep -c ':1DF3 ' /proc/net/udp; } # port 7667
listening() { [ "$(listeners)" -ge "$1" ]; }
has_size() { [ "$(stat -c %s "$1" 2>/dev/null || echo 0)" -ge "$2" ]; }

# Before anyone counts messages: a program of liblcm that begins to hear sends one itself, LCM_SELF_TEST.
begin_log() { # begin_log FILE: lcm-logger, ready to hear
  local before
  before=$(listeners)
  lcm-logger --lcm-url="$url" --flush-interval=20 --force "$1" >"$here/logger.txt" 2>&1 &
  logger=$!
  children+=("$logger")
  await listening $((before + 1))
}
# lcm-logger writes what it holds when it hears the next message after the interval: so it is told more until it has
# written what counts. tool.escript leaves that out.
has_logged() { "$tool" poke "$url" && has_size "$1" "$2"; }
end_log() { # end_log FILE SIZE: when it has written that much
  await has_logged "$1" "$2"
  kill -INT "$logger"
  wait "$logger"
}
begin_listening() { # begin_listening COUNT: the Erlang side; tells in $here/heard.txt
  rm -f "$here/heard.txt"
  "$tool" listen "$url" "$1" >"$here/heard.txt" 2>&1 &
  listener=$!
  children+=("$listener")
  await grep -qs listening "$here/heard.txt"
}
heard() { # heard TEXT STORED: the same as what is stored
  wait "$listener"
  check "$1" same "$2" "$(tail -n 1 "$here/heard.txt")"
}

# A thousand copters: frames of 78 kB, which LCM sends in two fragments.
thousand() {
  printf '{"format": "coptersim-scenario/1", "name": "thousand", "dt_us": 5000, "duration_us": 500000, "copters": ['
  local i
  for ((i = 0; i < 1000; i++)); do
    printf '%s{"id": %d, "pos": [%d, %d]}' "$([ "$i" = 0 ] || echo ,)" "$i" $((i % 40 * 5)) $((i / 40 * 5))
  done
  printf ']}\n'
}
thousand >"$here/thousand.json"

# between SCENARIO OPTION...: all four programs on one flight
between() {
  local name stored count size
  name=$(basename "$1" .json)
  "$bin/coptersim_stream" --log "$here/stored.lcm" "$@" >/dev/null || return
  stored=$("$tool" digest "$here/stored.lcm")
  count=${stored%% *}
  size=$(stat -c %s "$here/stored.lcm")

  begin_log "$here/logged.lcm"
  begin_listening "$count"
  check "$name: coptersim_stream publishes" "$bin/coptersim_stream" "--lcm-url=$url" "$@"
  heard "$name: the Erlang side hears all of it" "$stored"
  end_log "$here/logged.lcm" "$size"
  check "$name: lcm-logger records all of it" same "$stored" "$("$tool" digest "$here/logged.lcm")"

  begin_listening "$count"
  check "$name: lcm-logplayer plays" lcm-logplayer --lcm-url="$url" "$here/logged.lcm"
  heard "$name: the Erlang side hears what is played" "$stored"

  begin_log "$here/again.lcm"
  check "$name: the Erlang side plays" "$tool" play "$here/stored.lcm" "$url"
  end_log "$here/again.lcm" "$size"
  check "$name: lcm-logger records what the Erlang side plays" same "$stored" "$("$tool" digest "$here/again.lcm")"
}
between examples/copter/reflection.json --set duration_us=1500000
between "$here/thousand.json"
check "frames of a thousand objects need fragments" has_size "$here/stored.lcm" 2000000

# ---- Nothing leaves the host ----

# From here on there is a way out, as on any machine: whatever leaves comes in at the other end of the pair.
ip link add out type veth peer name other ||
  { echo "not ok a way out to watch: needs root or user namespaces"; exit 1; }
ip link set out addrgenmode none
ip link set other addrgenmode none
ip address add 192.0.2.1/24 dev out
ip neighbour add 192.0.2.2 lladdr 02:00:00:00:00:02 dev out
ip link set out up
ip link set other up
ip route add default via 192.0.2.2
left() { ip -s -o link show other | sed -E 's/.*RX: [^\\]*\\ *[0-9]+ +([0-9]+) .*/\1/'; }

stored=$("$tool" digest "$here/stored.lcm")
before=$(left)
ip route del 239.0.0.0/8 dev lo
begin_listening "${stored%% *}"
"$tool" play "$here/stored.lcm" "$url"
heard "the Erlang side is heard without a route" "$stored"
one_line() { # one_line STATUS PATTERN COMMAND...
  local status=0 output
  output=$("${@:3}" 2>&1) || status=$?
  [ "$status" = "$1" ] && [ "$(wc -l <<<"$output")" = 1 ] && grep -qE -- "$2" <<<"$output" && return
  printf 'exit status %s, expected %s and one line with "%s":\n%s\n' "$status" "$1" "$2" "$output"
  return 1
}
stream=("$bin/coptersim_stream" examples/copter/crossing.json)
check "without a route to the loopback coptersim_stream says which" \
  one_line 2 'run: ip route replace 239.255.76.67/32 dev lo src 127.0.0.1$' "${stream[@]}"
ip route del default
check "without any route too" one_line 2 'run: ip route replace 239.255.76.67/32 dev lo src 127.0.0.1$' "${stream[@]}"
ip route add default via 192.0.2.2
ip route add 239.255.76.67/32 dev lo
begin_log "$here/logged.lcm"
begin_listening "${stored%% *}"
check "coptersim_stream publishes beside a way out" "$bin/coptersim_stream" "--lcm-url=$url" "$here/thousand.json"
heard "and is heard" "$stored"
end_log "$here/logged.lcm" "$(stat -c %s "$here/stored.lcm")"
check "nothing has left the host" same "$before" "$(left)"
echo anything >/dev/udp/192.0.2.2/9
check "what leaves the host would have been seen" same $((before + 1)) "$(left)"

[ $failures -eq 0 ]
