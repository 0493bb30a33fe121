#!/usr/bin/env bash
# The simulator gives the same bytes on every machine: traces of the examples and of the recorded scenarios by each
# build of the inner loops that this machine can run, on several threads, and by a build for AArch64 under emulation.
source "$(dirname "$0")/lib.sh"

traces="_build/reports/machines"
native=_build/native/bin/coptersim_run
arm=_build/cmake/aarch64/out/bin/coptersim_run

for tool in aarch64-linux-gnu-g++ qemu-aarch64 python3; do
  command -v "$tool" >/dev/null || { echo "$tool is missing; run: scripts/setup.sh test"; finish 1; }
done
for kind in release aarch64; do
  scripts/build_native.sh "$kind" coptersim_run >"$reports/build-machines-$kind.log" 2>&1 || {
    tail -n 40 "$reports/build-machines-$kind.log"
    echo "the $kind build failed"
    finish 1
  }
done

rm -rf "$traces"
mkdir -p "$traces"
cp examples/copter/*.json "$traces"
python3 - "$traces" <<'PYTHON'
import gzip, json, sys
golden = json.load(gzip.open("test/data/coptersim_golden.json.gz"))
for entry in golden["entries"]:
    scenario = entry["scenario"]
    with open(f"{sys.argv[1]}/{scenario['name']}.json", "w") as file:
        json.dump(scenario, file)

# Enough copters for every vector width and for several threads, with faults that draw random numbers.
copters = [{"id": i, "pos": [2.5 * (i % 12), 2.5 * (i // 12)], "yaw": 37 * i % 360 - 180} for i in range(130)]
events = [{"t_us": 15000 * i, "type": "command", "copter": i, "roll": (i % 7 - 3) / 5, "pitch": (i % 5 - 2) / 4,
           "yaw": (i % 3 - 1) / 2} for i in range(130)]
for i in range(0, 130, 13):
    events += [
        {"t_us": 100000, "type": "fault", "probe": f"RollId{i}", "model": "noise_gauss", "deviation": 2},
        {"t_us": 200000, "type": "fault", "probe": f"YawId{i + 1}", "model": "drift_timed", "rate": 3},
        {"t_us": 300000, "type": "fault", "probe": f"RangeId{i}Anch0", "model": "random_offset", "low": 0.5, "high": 8,
         "probability": 0.3},
        {"t_us": 0, "type": "packet_fault", "channel": f"ITS_DATA{i + 2}", "model": "delay", "ns": 150000000}]
grid = {"format": "coptersim-scenario/1", "name": "grid", "dt_us": 5000, "duration_us": 4000000,
        "halt_on_collision": False, "params": {"integrator": "exact"}, "copters": copters, "events": events,
        "world": {"lines": [{"id": 0, "p1": [-2, -2], "p2": [32, -2]}],
                  "anchors": [{"id": 0, "pos": [0, 0, 2]}, {"id": 1, "pos": [30, 0, 2]}]}}
with open(f"{sys.argv[1]}/grid.json", "w") as file:
    json.dump(grid, file)
PYTHON

# same NAME COMMAND...: the command's traces of all scenarios have the bytes of the first one that was run.
same() {
  local name=$1 scenario out
  shift
  for scenario in "$traces"/*.json; do
    out="${scenario%.json}.$name.trace"
    check "trace of $(basename "$scenario") by $name" "$@" --out "$out" "$scenario"
    if [ -z "$first" ]; then continue; fi
    check "$(basename "$scenario"): $name as $first" cmp "$out" "${scenario%.json}.$first.trace"
    rm -f "$out"
  done
  [ -z "$first" ] && first=$name
  compared+=("$name")
}

first=
compared=()
not_here=()
for build in sse2 avx2 avx512; do
  if "$native" --build "$build" --out /dev/null "$traces/hover.json" 2>/dev/null; then
    same "$build" "$native" --build "$build"
  else
    not_here+=("$build")
  fi
done
same threads "$native" --threads 3
same aarch64 qemu-aarch64 -L /usr/aarch64-linux-gnu "$arm"

echo "the same bytes by: ${compared[*]} ($(find "$traces" -name '*.json' | wc -l) scenarios each)"
[ ${#not_here[@]} -eq 0 ] || echo "not compared, this machine cannot run them: ${not_here[*]}"
[[ " ${compared[*]} " = *" sse2 "* ]] || { echo "not even sse2 was compared"; finish 1; }
finish
