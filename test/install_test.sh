#!/usr/bin/env bash
# Installs into a prefix, moves it, and uses it as an ordinary user in a folder outside the clone: a new project, its
# first found fault, replay; the C libraries through CMake and pkg-config.
set -uo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
here=$(mktemp -d "${TMPDIR:-/tmp}/faultcheck-install-XXXXXX")
trap 'rm -rf "$here"' EXIT

failures=0
check() { # check TEXT COMMAND...: prints "ok TEXT" or "not ok TEXT" with the output
  local text=$1 output
  shift
  if output=$("$@" 2>&1); then
    echo "ok $text"
  else
    echo "not ok $text"
    sed 's/^/    /' <<<"$output"
    failures=$((failures + 1))
  fi
}

# user COMMAND: as an ordinary user, knowing the installed tree and nothing of the clone
user() {
  local drop=()
  [ "$(id -u)" != 0 ] || drop=(setpriv --reuid=65534 --regid=65534 --clear-groups)
  (cd "$here/home" && "${drop[@]}" env -i HOME="$here/home" PATH="$here/moved/bin:/usr/local/bin:/usr/bin:/bin" \
    LANG=C.UTF-8 TMPDIR="$here/home" bash -c "$1")
}
exits() { # exits STATUS PATTERN COMMAND: exit status and a line of the output that must match
  local output status=0
  output=$(user "$3") || status=$?
  [ "$status" = "$1" ] && grep -qE -- "$2" <<<"$output" && return 0
  printf 'exit status %s, expected %s and a line matching "%s":\n%s\n' "$status" "$1" "$2" "$output"
  return 1
}
names_nowhere() { ! grep -rlF -- "$1" "$here/moved"; }

mkdir "$here/home"
check "make install succeeds" "$root/scripts/install.sh" "$here/prefix"
mv "$here/prefix" "$here/moved"
check "no installed file names the prefix" names_nowhere "$here/prefix"
chmod -R a+rX "$here"
chmod a+rwx "$here/home"

check "the version is that of VERSION" exits 0 "$(cat "$root/VERSION")" 'faultcheck --version'
check "faultcheck new makes a project" exits 0 'mine' 'faultcheck new mine'
check "a project is not overwritten" exits 2 'mine' 'faultcheck new mine'
check "its model has at most 20 lines" exits 0 '' \
  '[ $(grep -hvE "^ *(%|$)" mine/test/prop_*.erl | wc -l) -le 20 ]'
check "the bug in its C file is found" exits 1 'prop_' 'cd mine && faultcheck proper'
check "the failure is stored as a case" exits 0 'case.json' 'ls mine/cases/*/case.json'
check "the stored case fails again" exits 1 '' 'cd mine && faultcheck replay cases/*'
check "rebar3 proper finds it too" exits 1 'prop_' \
  'cd mine && ERL_LIBS='"$here"'/moved/lib/faultcheck rebar3 proper'
check "an unknown command is one line" exits 2 'nonsense' 'faultcheck nonsense'

# play OPTIONS: begins, tells where to, and is ended.
play() {
  exits 0 '^play: sends to 127.0.0.1:7999' \
    'mkdir -p empty && cd empty
     exec 3< <(exec faultcheck play --paused --udp 127.0.0.1:7999 '"$1"' 2>&1) && player=$!
     read -r line <&3; echo "$line"; kill $player; wait $player || true'
}
check "the player plays its example in an empty folder" play ''
check "and a live flight" play --live
check "a case that is not there is one line" exits 2 '^play: no case nosuch' 'faultcheck play nosuch 2>&1'
check "play, report and export tell their usage" exits 0 '^Usage: faultcheck export' \
  'faultcheck play --help && faultcheck report --help && faultcheck export --help'
if [ -f "$root/visualizer/dist/bridge.mjs" ] && command -v node >/dev/null; then
  check "the bridge comes along" exits 0 'page.html beside' \
    'node '"$here"'/moved/share/faultcheck/visualizer/bridge.mjs --help'
fi

# Each C library: versioned, and it exports just what its headers declare.
versioned() { # versioned LIB: libX.so -> libX.so.MAJOR -> libX.so.VERSION, and programs ask for libX.so.MAJOR
  local lib="$here/moved/lib/$1" version major
  version=$(cat "$root/VERSION") major=${version%%.*}
  [ "$(readlink "$lib.so")" = "$1.so.$major" ] && [ "$(readlink "$lib.so.$major")" = "$1.so.$version" ] &&
    readelf -d "$lib.so" | grep -F "Library soname: [$1.so.$major]"
}
exports_what_is_declared() { # exports_what_is_declared LIB PREFIX: names that begin with PREFIX
  local exported declared
  exported=$(nm -D --defined-only "$here/moved/lib/$1.so" | awk '{ print $3 }' | sort -u)
  declared=$(cat "$here"/moved/include/*.h | gcc -fpreprocessed -dD -E -P -x c - 2>/dev/null | tr '\n' ' ' |
    grep -oE "[A-Z0-9]+_API [^;(]*[ *]($2)[A-Za-z0-9_]+\(" | grep -oE "[A-Za-z0-9_]+\($" | tr -d '(' | sort -u)
  [ "$(wc -l <<<"$declared")" -ge 10 ] && diff <(echo "$declared") <(echo "$exported")
}
for library in "libfaultcheck fc_|faultcheck_" "libe2e E2E_|Crc_" "libcoptersim csim_|coptersim_"; do
  check "${library% *} is versioned" versioned "${library% *}"
  check "${library% *} exports what its headers declare" exports_what_is_declared "${library% *}" "${library#* }"
done

mkdir "$here/home/c" && chmod a+rwx "$here/home/c"
cat >"$here/home/c/probe.c" <<'C'
#include <E2E_P01.h>
#include <faultcheck_wrapper.h>
#include <stdio.h>
int main(void) {
    int value = 7;
    faultcheck_addFaultOffset("speed", 3);
    faultcheck_injectFaultInt("speed", &value);
    printf("%d\n", value);
    return value == 10 ? 0 : 1;
}
C
cat >"$here/home/c/CMakeLists.txt" <<'C'
cmake_minimum_required(VERSION 3.25)
project(probe C)
find_package(faultcheck REQUIRED)
find_package(e2e REQUIRED)
find_package(coptersim REQUIRED)
add_executable(probe probe.c)
target_link_libraries(probe PRIVATE faultcheck::faultcheck e2e::e2e)
add_executable(flight flight.c)
target_link_libraries(flight PRIVATE coptersim::coptersim)
C
cat >"$here/home/c/flight.c" <<'C'
#include <coptersim_wrapper.h>
#include <stdio.h>
int main(void) {
    /* Half a tilt forwards for a second, in steps of a millisecond. */
    CONTROL_INPUT_t command = {0, 0.5, 0, 0};
    csim_state state;
    coptersim_addCopter(3, 4, 7);
    coptersim_setControlInput(7, command);
    coptersim_runIterations(1000, 1000, 50, 50);
    if (csim_get_state(csim_default(), 7, CSIM_TRUE, &state) != CSIM_OK)
        return 1;
    printf("moved %d\n", state.px != 3 || state.py != 4);
    return 0;
}
C
check "a C program finds both libraries with CMake" exits 0 '^10$' \
  'cmake -S c -B c/build -DCMAKE_PREFIX_PATH='"$here"'/moved >/dev/null && cmake --build c/build >/dev/null &&
   c/build/probe'
check "and with pkg-config" exits 0 '^10$' \
  'export PKG_CONFIG_PATH='"$here"'/moved/lib/pkgconfig LD_LIBRARY_PATH='"$here"'/moved/lib
   gcc c/probe.c $(pkg-config --cflags --libs faultcheck e2e) -o c/probe && c/probe'
check "a C program flies a copter" exits 0 '^moved 1$' 'c/build/flight'
check "also with pkg-config" exits 0 '^moved 1$' \
  'export PKG_CONFIG_PATH='"$here"'/moved/lib/pkgconfig LD_LIBRARY_PATH='"$here"'/moved/lib
   gcc c/flight.c $(pkg-config --cflags --libs coptersim) -o c/flight && c/flight'

# The embedded profile: as a library for the host, and as source for firmware.
mkdir "$here/home/embedded" && chmod a+rwx "$here/home/embedded"
cat >"$here/home/embedded/probe.c" <<'C'
#include <fi.h>
#include <stdio.h>
static void show(const char *line) {
    puts(line);
}
int main(void) {
    int value = 7;
    fi_init();
    fi_process_line("fi_set_enabled 1", show);
    fi_process_line("fi_add_fault speed AMPLIFICATION -1.5 0 0", show);
    fi_inject_fault_int("speed", &value);
    printf("%d\n", value);
    return value == -10 ? 0 : 1;
}
C
cat >"$here/home/embedded/CMakeLists.txt" <<'C'
cmake_minimum_required(VERSION 3.25)
project(probe C)
find_package(faultcheck REQUIRED)
add_executable(probe probe.c)
target_link_libraries(probe PRIVATE faultcheck::embedded)
C
check "a C program finds the embedded profile with CMake" exits 0 '^-10$' \
  'cmake -S embedded -B embedded/build -DCMAKE_PREFIX_PATH='"$here"'/moved >/dev/null &&
   cmake --build embedded/build >/dev/null && embedded/build/probe'
check "its source compiles alone" exits 0 '^-10$' \
  'from='"$here"'/moved/share/faultcheck/embedded
   gcc -std=c99 -I $from embedded/probe.c $from/fi.c -o embedded/probe && embedded/probe'
[ $failures -eq 0 ]
