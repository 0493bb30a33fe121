/* State in all places that a reset may or may not cover. */
#include <stdlib.h>

int in_data = 1;
int in_bss;
static int *on_heap;
_Thread_local int in_thread;
static _Thread_local int private_to_thread;
static int constructed;

__attribute__((constructor)) static void construct(void) {
    constructed = 7;
}

int touch(void) {
    in_data++;
    in_bss++;
    in_thread++;
    private_to_thread++;
    constructed++;
    if (on_heap == 0)
        on_heap = calloc(1, sizeof(int));
    return ++*on_heap;
}
int thread_value(void) {
    return in_thread;
}
int constructed_value(void) {
    return constructed;
}
