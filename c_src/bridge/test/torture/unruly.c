/* Code that ends badly, each in its own way. */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>

int calls;

int read_through(const int *p) {
    return *p;
}
int jump_to_nothing(void) {
    int (*volatile nothing)(void) = NULL;
    return nothing() + 1;
}
int divide(int a, int b) {
    return a / b;
}
void give_up(void) {
    abort();
}
int recurse(int depth) {
    volatile char room[256];
    room[0] = (char)depth;
    return depth == 0 ? 0 : recurse(depth - 1) + room[0];
}
int wait_forever(void) {
    for (;;) {
        ++calls;
    }
}
void leave(int status) {
    exit(status);
}
int count(void) {
    return ++calls;
}
void say(const char *text) {
    printf("%s\n", text);
}
