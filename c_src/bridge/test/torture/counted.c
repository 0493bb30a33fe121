/* Compiled with coverage counters: the lines of this file are counted by gcov. */
int state;
int counted_call(void) {
    return ++state;
}
