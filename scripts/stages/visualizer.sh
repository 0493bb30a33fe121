#!/usr/bin/env bash
# The visualizer without a browser: types, lint, unit tests of codec, bridge and page, and that visualizer/dist/ is what
# the sources make, in whatever folder they are.
source "$(dirname "$0")/lib.sh"
log="$reports/visualizer.log"

scripts/build_visualizer.sh >"$log" 2>&1 || {
  tail -n 20 "$log"
  echo "the visualizer was not built"
  finish 1
}
in_package() { (cd visualizer && "$@"); }
check "types (npm run typecheck)" in_package npm run --silent typecheck
check "lint and format (npm run lint; npm run format mends)" in_package npm run --silent lint

# With what sends packets kept on this host.
rm -f "$reports/visualizer.xml"
in_package ../scripts/loopback.sh npx vitest run --reporter=default --reporter=junit \
  --outputFile.junit="$reports/visualizer.xml" >>"$log" 2>&1
status=$?
[ $status -eq 0 ] || tail -n 60 "$log" | plain
if [ -f "$reports/visualizer.xml" ]; then count_junit "$reports/visualizer.xml"; fi

# The same sources elsewhere give the same bytes, with nothing of this folder in them.
elsewhere=$root/_build/visualizer/elsewhere
rm -rf "$elsewhere"
mkdir -p "$elsewhere"
trap 'rm -rf "$elsewhere"' EXIT
git ls-files -co --exclude-standard visualizer lcm docs | grep -v '^visualizer/dist/' |
  tar -c -T - | tar -x -C "$elsewhere"
cp -al visualizer/node_modules "$elsewhere/visualizer/node_modules" # no link: the tools would see where it leads
(cd "$elsewhere/visualizer" && npm run --silent build) >>"$log" 2>&1 || status=1
no_paths() { ! grep -l -e "$root" -e "$elsewhere" -e "$HOME/" "$1"; }
committed() { git cat-file -p "HEAD:visualizer/dist/$1" | cmp - "$elsewhere/visualizer/dist/$1"; }
for file in page.html bridge.mjs; do
  check "$file is the same when built elsewhere" cmp "visualizer/dist/$file" "$elsewhere/visualizer/dist/$file"
  check "$file names no folder of this machine" no_paths "visualizer/dist/$file"
  if git cat-file -e "HEAD:visualizer/dist/$file" 2>/dev/null; then
    check "visualizer/dist/$file is what the sources make; run scripts/build_visualizer.sh" committed "$file"
  fi
done
check "the bridge starts with this machine's Node" node visualizer/dist/bridge.mjs --help
finish $status
