#define _GNU_SOURCE
#include "slices.h"

#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { SLICES = 24, ROUNDS = 5, SLICE_US = 400 };

void bench_pin(void) {
    cpu_set_t own;
    CPU_ZERO(&own);
    CPU_SET((unsigned)sched_getcpu(), &own);
    sched_setaffinity(0, sizeof own, &own);
}

void bench_unpin(void) {
    cpu_set_t all;
    memset(&all, 0xff, sizeof all);
    sched_setaffinity(0, sizeof all, &all);
}

static double now_ns(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1e9 * (double)now.tv_sec + (double)now.tv_nsec;
}

static double slice_ns(bench_fn operation, long count) {
    double start = now_ns();
    operation(count);
    return (now_ns() - start) / (double)count;
}

static int by_value(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double bench_ns(bench_fn operation) {
    double rounds[ROUNDS];
    long count = 1000;
    while (slice_ns(operation, count) * (double)count < 1e3 * SLICE_US)
        count *= 2;
    for (int round = 0; round < ROUNDS; round++) {
        rounds[round] = slice_ns(operation, count);
        for (int i = 1; i < SLICES; i++) {
            double ns = slice_ns(operation, count);
            if (ns < rounds[round])
                rounds[round] = ns;
        }
    }
    qsort(rounds, ROUNDS, sizeof rounds[0], by_value);
    return rounds[ROUNDS / 2];
}

void bench_print(const char *key, double value, const char *unit, const char *baseline,
                 double baseline_value) {
    printf("{\"key\":\"%s\",\"value\":%.3f,\"unit\":\"%s\",\"baseline\":\"%s\","
           "\"baseline_value\":%.3f}\n",
           key, value, unit, baseline, baseline_value);
}
