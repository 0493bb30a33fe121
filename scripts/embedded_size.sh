#!/usr/bin/env bash
# Compiles the embedded profile of libfaultcheck for a Cortex-M4, prints what it takes there, and checks the bounds.
#
#   scripts/embedded_size.sh [COMPILER-OPTION...]     e.g. -DFI_PROBES=2: prints, without bounds
#
# Checked: text and read-only data <= 3072 bytes, RAM <= 700 bytes, and that it links with nothing but libgcc.
# Exit status 1 when one of them fails; 2 without the compiler (arm-none-eabi-gcc).
set -euo pipefail
cd "$(dirname "$0")/.."
most_text=3072
most_ram=700
[ $# -eq 0 ] || { most_text=1000000 most_ram=1000000; }
cross=arm-none-eabi
flags=(-mcpu=cortex-m4 -mthumb -Os -ffreestanding)
strict=(-std=c99 -Wall -Wextra -pedantic -Werror)
out=_build/embedded

command -v "$cross-gcc" >/dev/null 2>&1 || {
  echo "embedded_size: $cross-gcc is missing; run: scripts/setup.sh test" >&2
  exit 2
}
mkdir -p "$out"
status=0
fail() { echo "embedded_size: $1" >&2; status=1; }

"$cross-gcc" "${flags[@]}" "${strict[@]}" -fstack-usage "$@" -c c_src/faultcheck/embedded/fi.c -o "$out/fi.o"

# size -A: a line for each section, "NAME SIZE ADDRESS"
read -r text rodata ram < <("$cross-size" -A "$out/fi.o" | awk '
  $1 ~ /^\.text/        { text += $2 }
  $1 ~ /^\.rodata/      { rodata += $2 }
  $1 ~ /^\.(data|bss)/  { ram += $2 }
  END                   { print text + 0, rodata + 0, ram + 0 }')
stack=$(awk -F '\t' '$2 > most { most = $2 } END { print most + 0 }' "$out/fi.su")
printf 'embedded profile, Cortex-M4, -Os (%s):\n' "$("$cross-gcc" -dumpversion)"
printf '  text %d + rodata %d = %d bytes, at most %d\n' "$text" "$rodata" $((text + rodata)) "$most_text"
printf '  RAM %d bytes, at most %d; largest stack frame %d bytes\n' "$ram" "$most_ram" "$stack"
[ $((text + rodata)) -le "$most_text" ] || fail "text and rodata take $((text + rodata)) bytes, more than $most_text"
[ "$ram" -le "$most_ram" ] || fail "RAM is $ram bytes, more than $most_ram"
[ "$text" -gt 0 ] && [ "$ram" -gt 0 ] || fail "the object file is empty"

foreign=$("$cross-nm" -u "$out/fi.o" | awk '$2 !~ /^__aeabi_/ { print $2 }')
[ -z "$foreign" ] || fail "needs more than libgcc: $foreign"

# A program that uses all of it links without a C library.
cat >"$out/main.c" <<'EOC'
#include "fi.h"
void _start(void);
void _start(void) {
    float x = 1;
    int n = 1;
    fi_init();
    fi_process_line("fi_print_faults", 0);
    fi_inject_fault_float("x", &x);
    fi_inject_fault_int("n", &n);
    while (fi_is_active()) {
    }
}
EOC
"$cross-gcc" "${flags[@]}" "${strict[@]}" -nostdlib -I c_src/faultcheck/embedded "$out/main.c" "$out/fi.o" -lgcc \
  -o "$out/program.elf" || fail "does not link with libgcc alone"
[ $status -ne 0 ] ||
  printf '  a program with it and the soft double of libgcc: %d bytes\n' \
    "$("$cross-size" "$out/program.elf" | awk 'END { print $1 }')"
exit $status
