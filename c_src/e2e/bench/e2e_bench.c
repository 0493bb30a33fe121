/* Benchmarks of libe2e, linked as a user links it. Prints one JSON line a figure (bench/README.md).
 *
 * A figure is protect-and-check pairs per second through the shared library, divided by those of
 * table_bound.h measured in the same run. Both receive every packet they send; a pair that is not
 * OK ends the program. */
#define _POSIX_C_SOURCE 200809L
#include "E2E_P01.h"
#include "E2E_P04.h"
#include "E2E_P07.h"
#include "table_bound.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define SLICES 16
#define ROUNDS 5

static const BoundTables *tables;

/* The packet goes over a wire: what the sender computed is unknown to the receiver's side, however
 * much is inlined. */
static inline void transmit(uint8 *data) {
    __asm__ volatile("" : : "r"(data) : "memory");
}

static void must(int good) {
    if (!good) {
        fprintf(stderr, "e2e_bench: a packet just protected was not accepted\n");
        exit(1);
    }
}

static void p01_bound(long pairs) {
    uint8_t data[8] = {0}, counter = 1, last = 0;
    int good = 1;
    for (long i = 0; i < pairs; i++) {
        data[7] = (uint8_t)i;
        bound_p01_protect(tables, 0x123, &counter, data, 8);
        transmit(data);
        good &= bound_p01_check(tables, 0x123, &last, data, 8);
    }
    must(good);
}

static void p01_library(long pairs) {
    static const E2E_P01ConfigType config = {.CounterOffset = 8,
                                             .CRCOffset = 0,
                                             .DataID = 0x123,
                                             .DataIDMode = E2E_P01_DATAID_BOTH,
                                             .DataLength = 64,
                                             .MaxDeltaCounterInit = 1,
                                             .MaxNoNewOrRepeatedData = 14};
    E2E_P01ProtectStateType sender = {1};
    E2E_P01CheckStateType receiver = {.MaxDeltaCounter = 1, .NewDataAvailable = TRUE};
    uint8 data[8] = {0};
    int good = 1;
    for (long i = 0; i < pairs; i++) {
        data[7] = (uint8)i;
        E2E_P01Protect(&config, &sender, data);
        transmit(data);
        E2E_P01Check(&config, &receiver, data);
        good &= receiver.Status == E2E_P01STATUS_OK;
    }
    must(good);
}

static void p04_bound(long pairs) {
    uint8_t data[256] = {0};
    uint16_t counter = 1, last = 0;
    int good = 1;
    for (long i = 0; i < pairs; i++) {
        data[200] = (uint8_t)i;
        bound_p04_protect(tables, 0x0a0b0c0d, &counter, data, 256);
        transmit(data);
        good &= bound_p04_check(tables, 0x0a0b0c0d, &last, data, 256);
    }
    must(good);
}

static void p04_library(long pairs) {
    static const E2E_P04ConfigType config = {
        .DataID = 0x0a0b0c0d, .MinDataLength = 96, .MaxDataLength = 32768, .MaxDeltaCounter = 1};
    E2E_P04ProtectStateType sender = {1};
    E2E_P04CheckStateType receiver = {.Counter = 0};
    uint8 data[256] = {0};
    int good = 1;
    for (long i = 0; i < pairs; i++) {
        data[200] = (uint8)i;
        E2E_P04Protect(&config, &sender, data, 256);
        transmit(data);
        E2E_P04Check(&config, &receiver, data, 256);
        good &= receiver.Status == E2E_P04STATUS_OK;
    }
    must(good);
}

static void p07_bound(long pairs) {
    uint8_t data[256] = {0};
    uint32_t counter = 1, last = 0;
    int good = 1;
    for (long i = 0; i < pairs; i++) {
        data[200] = (uint8_t)i;
        bound_p07_protect(tables, 0x0a0b0c0d, &counter, data, 256);
        transmit(data);
        good &= bound_p07_check(tables, 0x0a0b0c0d, &last, data, 256);
    }
    must(good);
}

static void p07_library(long pairs) {
    static const E2E_P07ConfigType config = {
        .DataID = 0x0a0b0c0d, .MinDataLength = 160, .MaxDataLength = 32768, .MaxDeltaCounter = 1};
    E2E_P07ProtectStateType sender = {1};
    E2E_P07CheckStateType receiver = {.Counter = 0};
    uint8 data[256] = {0};
    int good = 1;
    for (long i = 0; i < pairs; i++) {
        data[200] = (uint8)i;
        E2E_P07Protect(&config, &sender, data, 256);
        transmit(data);
        E2E_P07Check(&config, &receiver, data, 256);
        good &= receiver.Status == E2E_P07STATUS_OK;
    }
    must(good);
}

static double seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Pairs per second of the fastest slice. */
static double fastest(void (*run)(long), long pairs) {
    double best = 0;
    for (int slice = 0; slice < SLICES; slice++) {
        const double before = seconds();
        run(pairs);
        const double rate = (double)pairs / (seconds() - before);
        best = rate > best ? rate : best;
    }
    return best;
}

static int by_size(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values) {
    qsort(values, ROUNDS, sizeof *values, by_size);
    return values[ROUNDS / 2];
}

/* `pairs` make a slice of about a millisecond. */
static void figure(const char *key, void (*library)(long), void (*bound)(long), long pairs) {
    double ratio[ROUNDS], rate[ROUNDS];
    for (int round = 0; round < ROUNDS; round++) {
        rate[round] = fastest(bound, pairs);
        ratio[round] = fastest(library, pairs) / rate[round];
    }
    printf("{\"key\":\"%s\",\"value\":%.3f,\"unit\":\"ratio\","
           "\"baseline\":\"byte-at-a-time table, M pairs/s\",\"baseline_value\":%.2f}\n",
           key, median(ratio), median(rate) / 1e6);
}

int main(void) {
    static BoundTables filled;
    bound_fill(&filled);
    tables = &filled;
    figure("e2e_p01_vs_table", p01_library, p01_bound, 30000);
    figure("e2e_p04_256_vs_table", p04_library, p04_bound, 1000);
    figure("e2e_p07_256_vs_table", p07_library, p07_bound, 1000);
    return 0;
}
