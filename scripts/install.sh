#!/usr/bin/env bash
# Installs below a prefix: bin/faultcheck, the Erlang applications, the C libraries with their CMake and pkg-config
# files. docs/architecture.md shows the tree. Nothing written names the prefix, so the tree can be moved.
set -euo pipefail
cd "$(dirname "$0")/.."
prefix=${1:?usage: scripts/install.sh PREFIX}
if ! mkdir -p "$prefix" 2>/dev/null || [ ! -w "$prefix" ]; then
  echo "install: cannot write to $prefix; choose another place: make install PREFIX=DIR" >&2
  exit 2
fi
prefix=$(cd "$prefix" && pwd)

scripts/build_native.sh release >/dev/null
rebar3 compile >/dev/null
version=$(cat VERSION)

cmake --install _build/cmake/release --prefix "$prefix" >/dev/null

install_app() { # install_app BUILT_DIR NAME
  local to="$prefix/lib/faultcheck/$2-$version"
  rm -rf "$to"
  mkdir -p "$to"
  local part
  for part in ebin priv include; do
    if [ -d "$1/$part" ]; then cp -rL "$1/$part" "$to/"; fi
  done
}
for app in c_bridge faultcheck eqc_compat replay copter_eqc; do
  install_app "_build/default/lib/$app" "$app"
done
install_app _build/default/checkouts/rebar3_faultcheck rebar3_faultcheck
# Reports are this page with a recording in it; the bridge serves it. A clone may not have them built.
if [ -f visualizer/dist/page.html ]; then
  install -D -m 644 visualizer/dist/page.html "$prefix/lib/faultcheck/replay-$version/priv/page.html"
  install -D -m 644 -t "$prefix/share/faultcheck/visualizer" visualizer/dist/page.html visualizer/dist/bridge.mjs
fi

install -D -m 755 bin/faultcheck "$prefix/bin/faultcheck"
echo "installed below $prefix; try: $prefix/bin/faultcheck new DIR"
