#!/usr/bin/env bash
# Takes the pictures docs/images/visualizer-{light,dark}.png of the page as it is built now, with a flight of
# examples/copter/crowd.json recorded by coptersim_stream.
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/build_native.sh release >/dev/null
scripts/build_visualizer.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
recording=$folder/crowd.lcm # as the page names it
_build/native/bin/coptersim_stream --log "$recording" --observer 7 examples/copter/crowd.json
(cd visualizer && npm run --silent screenshots -- "$recording" "$PWD/../docs/images")
ls -l docs/images/visualizer-light.png docs/images/visualizer-dark.png
