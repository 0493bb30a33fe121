/* Code under test that misbehaves as soon as its level reaches 10. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static int level;

static int at_limit(int by) {
    level += by;
    return level >= 10;
}

int good(int by) {
    level += by;
    return level;
}

int wrong(int by) {
    return at_limit(by) ? -1 : level;
}

int crash(int by) {
    if (at_limit(by)) {
        *(volatile int *)0 = level;
    }
    return level;
}

int hang(int by) {
    if (at_limit(by)) {
        for (volatile int forever = 1; forever;) {
        }
    }
    return level;
}

int leave(int by) {
    if (at_limit(by)) {
        exit(3);
    }
    return level;
}

/* Prints what would look like a packet, on both streams. */
int print(int by) {
    level += by;
    printf("\001\002\003 level %d\n", level);
    fflush(stdout);
    fprintf(stderr, "warning %d\n", level);
    return level;
}

/* Wrong about every fourth time, and only in the step that reaches the limit: were each step
 * beyond it a chance to be wrong, a long sequence would fail in ten of ten runs now and then. */
int flaky(int by) {
    int below = level < 10;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return at_limit(by) && below && (now.tv_nsec / 64) % 4 == 0 ? -1 : level;
}

/* Crashes in an Erlang VM only. */
int guest(int by) {
    char name[32] = "";
    FILE *comm = fopen("/proc/self/comm", "r");
    if (comm != NULL) {
        if (fgets(name, sizeof name, comm) == NULL) {
            name[0] = 0;
        }
        fclose(comm);
    }
    if (at_limit(by) && strncmp(name, "beam", 4) == 0) {
        *(volatile int *)0 = level;
    }
    return level;
}

/* Takes three tenths of a second in the step that reaches the limit. */
int slow(int by) {
    struct timespec delay = {0, 300000000};
    int below = level < 10;
    if (at_limit(by) && below) {
        nanosleep(&delay, NULL);
    }
    return level;
}
