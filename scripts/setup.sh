#!/usr/bin/env bash
# Installs what is missing for a purpose, and only that.
#
#   scripts/setup.sh [--quiet] native|demo|visualizer|bench|test|coverage|docs|all
#
# A requirement is a test (is the command, header or Erlang application there?) and the Debian package that supplies
# it, so tools installed in another way are left alone. The list is shown before anything is installed; a person is
# asked, CI=true is not. SETUP=no installs nothing: one line says what to run, exit status 2.
set -euo pipefail

quiet=no
[ "${1:-}" = --quiet ] && { quiet=yes; shift; }
purpose=${1:-all}

# purposes | requirement | Debian package
requirements() {
  cat <<'TABLE'
native  cmd:gcc                  gcc
native  cmd:g++                  g++
native  cmd:cmake                cmake
native  cmd:ninja                ninja-build
native  cmd:pkg-config           pkg-config
native  header:elfutils/libdwfl.h  libdw-dev
native  header:ffi.h             libffi-dev
native  cxxheader:nlohmann/json.hpp  nlohmann-json3-dev
native  cmd:erl                  erlang-base
native  erlang:erl_nif.h         erlang-dev
vectors header:zlib.h            zlib1g-dev
stream  header:lcm/lcm.h         liblcm-dev
stream  cmd:lcm-gen              liblcm-bin
visualizer cmd:node              nodejs
browser cmd:npm                  npm
browser cmd:chromium             chromium
browser cmd:ip                   iproute2
demo    app:eunit                erlang-eunit
demo    app:syntax_tools         erlang-syntax-tools
demo    cmd:rebar3               rebar3
demo    app:proper               erlang-proper
demo    erlang:proper.hrl        erlang-proper-dev
test    app:common_test          erlang-common-test
test    app:dialyzer             erlang-dialyzer
test    cmd:clang                clang
test    cmd:llvm-symbolizer      llvm
test    link:-fsanitize=fuzzer   libclang-rt
test    cmd:clang-format         clang-format
test    cmd:shellcheck           shellcheck
test    cmd:dwz                  dwz
test    cmd:git                  git
test    cmd:python3              python3
test    cmd:arm-none-eabi-gcc    gcc-arm-none-eabi
test    cmd:aarch64-linux-gnu-g++  g++-aarch64-linux-gnu
test    cmd:qemu-aarch64         qemu-user
coverage cmd:lcov                lcov
docs    cmd:git                  git
docs    cmd:erl                  erlang-base
docs    cmd:doxygen              doxygen
docs    app:edoc                 erlang-edoc
TABLE
}

included() {
  case "$purpose" in
    # The vector runner and coptersim_stream are not needed by `make demo`.
    native) [[ $1 = native || $1 = vectors || $1 = stream ]] ;;
    demo) [[ $1 = native || $1 = demo ]] ;;
    visualizer) [[ $1 = native || $1 = demo || $1 = visualizer ]] ;;
    bench) [[ $1 != test && $1 != coverage && $1 != docs ]] ;;
    docs) [[ $1 = docs ]] ;;
    coverage) [[ $1 = native || $1 = demo || $1 = coverage ]] ;;
    test | all) true ;;
    *)
      echo "setup: unknown purpose '$purpose' (native, demo, visualizer, bench, test, coverage, docs or all)" >&2
      exit 2
      ;;
  esac
}

erlang_libs=
erlang_lib_names() {
  if [ -z "$erlang_libs" ]; then
    command -v erl >/dev/null 2>&1 || return 1
    erlang_libs=" $(erl -noinput -boot start_clean -eval '
      [case code:lib_dir(A) of {error, _} -> ok; _ -> io:format("~s ", [A]) end
       || A <- [eunit, syntax_tools, proper, common_test, dialyzer, edoc]],
      [filelib:is_file(F) andalso io:format("~s ", [filename:basename(F)])
       || F <- [filename:join([code:root_dir(), "usr", "include", "erl_nif.h"]),
                filename:join([case code:lib_dir(proper) of {error, _} -> "/"; D -> D end,
                               "include", "proper.hrl"])]],
      halt().') "
  fi
}

present() {
  case "$1" in
    cmd:*) command -v "${1#cmd:}" >/dev/null 2>&1 ;;
    header:*) echo "#include <${1#header:}>" | cc -E -x c - >/dev/null 2>&1 ;;
    app:* | erlang:*) erlang_lib_names && [[ $erlang_libs = *" ${1#*:} "* ]] ;;
    cxxheader:*) echo "#include <${1#cxxheader:}>" | c++ -E -x c++ - >/dev/null 2>&1 ;;
    link:*)
      echo 'extern "C" int LLVMFuzzerTestOneInput(const unsigned char *, unsigned long) { return 0; }' |
        clang++ "${1#link:}" -x c++ - -o /dev/null >/dev/null 2>&1 ;;
  esac
}

missing=()
while read -r for_purpose requirement package; do
  included "$for_purpose" || continue
  present "$requirement" || missing+=("$package")
done < <(requirements)

if [ ${#missing[@]} -eq 0 ]; then
  [ $quiet = yes ] || echo "setup: everything for '$purpose' is there"
  exit 0
fi

if ! command -v apt-get >/dev/null 2>&1; then
  echo "setup: missing, and there is no apt-get to install it; please install what Debian calls: ${missing[*]}" >&2
  exit 2
fi

as_root=
if [ "$(id -u)" != 0 ]; then as_root="sudo "; fi

# The runtime library of libFuzzer is in a package named after clang's version.
clang_runtime() {
  local version
  version=$(apt-cache depends clang 2>/dev/null | sed -n 's/^ *Depends: clang-\([0-9]*\)$/\1/p' | head -1)
  echo "libclang-rt-${version:-14}-dev"
}
resolve_names() {
  local i
  for i in "${!missing[@]}"; do
    if [ "${missing[$i]}" = libclang-rt ]; then missing[i]=$(clang_runtime); fi
  done
}

resolve_names
line="${as_root}apt-get install --no-install-recommends ${missing[*]}"
if [ "${SETUP:-}" = no ]; then
  echo "setup: missing for '$purpose'; run: $line" >&2
  exit 2
fi
if [ -n "$as_root" ] && ! command -v sudo >/dev/null 2>&1; then
  echo "setup: missing for '$purpose'; as root run: ${line#sudo }" >&2
  exit 2
fi

echo "setup: for '$purpose' this will be installed: ${missing[*]}"
if [ "${CI:-}" != true ]; then
  if [ ! -t 0 ]; then
    echo "setup: nobody to ask here; set CI=true, or run: $line" >&2
    exit 2
  fi
  read -r -p "setup: go on? [Y/n] " answer
  case "$answer" in "" | y* | Y*) ;; *) echo "setup: nothing installed; the line is: $line" >&2; exit 2 ;; esac
fi

run_as_root() {
  if [ -z "$as_root" ]; then env DEBIAN_FRONTEND=noninteractive "$@"
  elif [ "${CI:-}" = true ]; then sudo -n env DEBIAN_FRONTEND=noninteractive "$@"
  else sudo env DEBIAN_FRONTEND=noninteractive "$@"; fi
}
log=$(mktemp)
trap 'rm -f "$log"' EXIT
fail() {
  tail -n 5 "$log" >&2
  echo "setup: $1; the line that failed: $line" >&2
  exit 2
}
# Sources of other vendors on the machine may be unreachable; what counts is whether the install works.
run_as_root apt-get update -q >"$log" 2>&1 || true
resolve_names
run_as_root apt-get install -y -q --no-install-recommends "${missing[@]}" >>"$log" 2>&1 </dev/null ||
  fail "installation failed"
# What was configured without these packages looks for them again.
rm -f "$(dirname "$0")"/../_build/cmake/*/CMakeCache.txt
echo "setup: done"
