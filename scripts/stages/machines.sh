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
