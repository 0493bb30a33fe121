#!/usr/bin/env bash
# Starts player, bridge and page on 127.0.0.1, prints the URL, and ends both when Ctrl-C is pressed:
#
#   scripts/visualizer.sh [CASE]     a stored case (or its id alone); without it an example
#
# LIVE=1 flies live in an empty world, SCENARIO=FILE in that of a scenario; ORIGINAL=1 plays the failure as it was
# found. TILES=DIR puts map tiles of a folder below the map (docs/visualizer_guide.md). PORT is that of the web server
# (8765), and decides the multicast port between the two: 7667 for 8765, and so on. One of the two that ends is started
# again, unless it ends at once.
set -euo pipefail
cd "$(dirname "$0")/.."
case=${1:-}
port=${PORT:-8765}
bridge=visualizer/dist/bridge.mjs
cases=${FAULTCHECK_CASES:-cases}

fail() {
  echo "visualizer: $1" >&2
  exit "$2"
}

# Sources that differ from what is committed, and are newer than the bridge. No git, no difference.
changed_since_build() {
  git diff --name-only --diff-filter=d HEAD -- visualizer ':!visualizer/dist' 2>/dev/null | while read -r source; do
    [ "$source" -ot "$bridge" ] || echo "$source"
  done
}

case $port in
  '' | *[!0-9]* | ??????*) fail "PORT: expected 0 to 65535, not $port" 2 ;;
esac
# 7667 + PORT - 8765, kept within 1024 to 65535.
group="udpm://239.255.76.67:$((1024 + (10#$port - 2122 + 64512) % 64512))?ttl=0"

what=()
if [ -n "$case" ]; then
  if [ ! -e "$case" ] && [ -d "$cases/$case" ]; then case=$cases/$case; fi
  [ -f "$case/case.json" ] || [ -f "$case/scenario.json" ] ||
    fail "no case $case; stored are the folders below $cases/" 2
  what+=("$case")
fi
if [ -n "${SCENARIO:-}" ] && [ ! -f "$SCENARIO" ]; then
  fail "no file $SCENARIO; scenarios are $(echo examples/copter/*.json)" 2
fi
[ -z "${ORIGINAL:-}" ] || what+=(--original)
[ -z "${LIVE:-}" ] || what+=(--live)
[ -z "${SCENARIO:-}" ] || what+=(--scenario "$SCENARIO")
tiles=()
[ -z "${TILES:-}" ] || tiles=(--tiles "$TILES")

mkdir -p _build
scripts/build_native.sh release >_build/native.log 2>&1 || { tail -n 30 _build/native.log >&2; exit 3; }
rebar3 compile >_build/compile.log 2>&1 || { tail -n 30 _build/compile.log >&2; exit 3; }
if [ ! -f "$bridge" ]; then
  command -v npm >/dev/null 2>&1 || fail "$bridge is missing, and there is no npm to build it; a release has it" 3
  echo "visualizer: building page and bridge ..."
  scripts/build_visualizer.sh
elif command -v npm >/dev/null 2>&1 && [ -n "$(changed_since_build)" ]; then
  echo "visualizer: page and bridge are older than their sources; to build them: scripts/build_visualizer.sh"
fi

# Nobody else may read the token that lets a page control the player.
private=$(mktemp -d)
output=$private/bridge.out
bridge_pid='' player_pid=''
control=(--allow-control --token-file "$private/token")

# In sessions of their own: Ctrl-C is for this script, which ends them once.
start_bridge() {
  setsid node "$bridge" --port "$port" --group "$group" --cases "$cases" "${tiles[@]}" "${control[@]}" >>"$output" &
  bridge_pid=$!
}
start_player() {
  setsid bin/faultcheck play "${what[@]}" --group "$group" --cases "$cases" "${control[@]}" &
  player_pid=$!
}

# The player first: it may have a flight to store.
end() {
  trap '' INT TERM
  for pid in $player_pid $bridge_pid; do
    kill -TERM "$pid" 2>/dev/null && wait "$pid" 2>/dev/null || true
  done
  rm -rf "$private"
  exit "$1"
}
trap 'end 130' INT TERM
trap 'rm -rf "$private"' EXIT

: >"$output"
start_bridge
# Its first line names the address; it ends without one when it cannot have it.
until grep -q '^bridge: http' "$output"; do
  if ! kill -0 "$bridge_pid" 2>/dev/null; then
    status=0
    wait "$bridge_pid" || status=$?
    end "$((status ? status : 3))"
  fi
  sleep 0.1
done
start_player
url=$(sed -n 's/^bridge: \(http[^ ]*\).*/\1/p' "$output" | head -1)
echo "visualizer: open $url in a browser; Ctrl-C ends it"

while true; do
  began=$SECONDS
  status=0
  wait -n "$bridge_pid" "$player_pid" || status=$?
  # 2: what it was asked for cannot be, such as a second player on the group
  { [ "$status" -ne 2 ] && [ $((SECONDS - began)) -ge 2 ]; } || end "$((status ? status : 3))"
  kill -0 "$bridge_pid" 2>/dev/null || { echo "visualizer: the bridge has ended; again"; start_bridge; }
  kill -0 "$player_pid" 2>/dev/null || { echo "visualizer: the player has ended; again"; start_player; }
done
