#!/usr/bin/env bash
# C and C++ tests of one build: native.sh release|asan|tsan. The thread sanitizer runs only tests labelled `threads`.
source "$(dirname "$0")/lib.sh"
kind=${1:-release}
select=()
targets=()
if [ "$kind" = tsan ]; then
  select=(-L threads)
  targets=(fc_thread_test fc_threads_test fi_thread_test csim_threads_test)
fi

scripts/build_native.sh "$kind" "${targets[@]}" >"$reports/build-$kind.log" 2>&1 || {
  tail -n 40 "$reports/build-$kind.log"
  echo "the $kind build failed"
  finish 1
}
xml="$reports/ctest-$kind.xml"
rm -f "$xml"
ASAN_OPTIONS=${ASAN_OPTIONS:-strict_string_checks=1:detect_stack_use_after_return=1} \
UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1} TSAN_OPTIONS=${TSAN_OPTIONS:-halt_on_error=1} \
  ctest --test-dir "_build/cmake/$kind" --parallel 2 --timeout 120 --output-on-failure --no-tests=error \
  "${select[@]}" --output-junit "$xml" >"$reports/ctest-$kind.log" 2>&1
status=$?
[ $status -eq 0 ] || tail -n 60 "$reports/ctest-$kind.log"
[ -f "$xml" ] && count_junit "$xml"
finish $status
