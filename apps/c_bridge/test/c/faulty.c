/* Every way to fail. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <unistd.h>

int steps;

int step(void) {
    return ++steps;
}
int follow(const int *p) {
    return *p;
}
int divide(int a, int b) {
    return a / b;
}
void give_up(void) {
    abort();
}
void leave(int status) {
    exit(status);
}
static int spin(void) {
    volatile int on = 1;
    while (on)
        steps++;
    return 0;
}
int hang(void) {
    return spin();
}
int recurse(int n) {
    volatile char room[256];
    memset((void *)room, n, sizeof(room));
    return n + recurse(n + 1) + room[n % 256];
}
int talk_and_crash(void) {
    fputs("last words\n", stderr);
    return follow((const int *)16);
}
void die_by(int signal_number) {
    char command[1];
    (void)command;
    extern int raise(int);
    raise(signal_number);
}
int wait_ms(int ms) {
    usleep((useconds_t)ms * 1000);
    return ms;
}
const char *thread_name(void) {
    static char name[16];
    prctl(PR_GET_NAME, name);
    return name;
}
int process(void) {
    return getpid();
}
