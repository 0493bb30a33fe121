/* A library that prints, on both outputs, with and without a line end. */
#include <stdio.h>
#include <unistd.h>

int said;

int say(const char *text) {
    printf("out: %s", text);
    fflush(stdout);
    fprintf(stderr, "err: %s\n", text);
    return ++said;
}
/* Bytes that look like a message of the port. */
int say_bytes(void) {
    return write(1, "\0\0\0\4abcd", 8) == 8 ? ++said : -1;
}
