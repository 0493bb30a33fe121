/* What the benchmarks call: a function that looks at a two-byte buffer, with 16 KiB of state for
 * the resets, and one that tells how much of the C heap is in use. */
#define _GNU_SOURCE
#include <malloc.h>
#include <stddef.h>

static unsigned char state[16384];

unsigned sum_of_two(const unsigned char *data) {
    state[data[0]] = data[1];
    return (unsigned)data[0] + data[1];
}

size_t heap_in_use(void) {
    struct mallinfo2 heap = mallinfo2();
    return heap.uordblks + heap.hblkhd;
}
