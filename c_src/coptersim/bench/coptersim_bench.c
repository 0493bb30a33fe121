/* coptersim_bench.c: what a simulation costs.
 *
 * The load: copters 4 m apart on a square, each rocking gently so that nobody stands still, steps
 * of 5 ms, messages and ranges every 100 ms, four anchors and four walls around, one thread. */
#define _POSIX_C_SOURCE 199309L
#include "csim.h"
#include "fc.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

enum { DT_US = 5000, DIVISOR = 20 };

/* Of this thread, so that a busy machine matters less. */
static double now_s(void) {
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static csim *make_world(int copters) {
    csim *sim = csim_new(NULL);
    int side = (int)ceil(sqrt((double)copters));
    double far = 4.0 * side + 4;
    csim_set(sim, "halt_on_collision", 0);
    for (int i = 0; i < 4; i++) {
        csim_add_anchor(sim, i, i < 2 ? -4 : far, i % 2 ? -4 : far, 2);
        csim_add_line(sim, i, i < 2 ? -6 : far + 2, i % 2 ? -6 : far + 2, i % 2 ? -6 : far + 2,
                      i < 2 ? far + 2 : -6);
    }
    for (int i = 0; i < copters; i++)
        csim_add_copter(sim, i, 4.0 * (i % side), 4.0 * (i / side), 0);
    return sim;
}

/* A command against the one before: nobody gets far from where it started. */
static void rock(csim *sim, int round) {
    double tilt = round % 2 == 0 ? 0.04 : -0.04;
    for (int i = 0; i < csim_count(sim); i++)
        csim_command(sim, i, i % 2 == 0 ? tilt : -tilt, i % 3 == 0 ? tilt : -tilt, 0, 0);
}

/* Processor seconds for two rocks of a second each. */
static double slice_s(csim *sim) {
    double start = now_s();
    for (int round = 0; round < 2; round++) {
        rock(sim, round);
        csim_run(sim, 1000000 / DT_US, DT_US, DIVISOR, DIVISOR);
    }
    return now_s() - start;
}

/* Simulated seconds a second: the fastest of many slices. */
static double speed_of(csim *sim, int copters) {
    int slices = 8 + 2000 / copters;
    double best = slice_s(sim);
    for (int slice = 1; slice < slices; slice++)
        best = fmin(best, slice_s(sim));
    return 2 / best;
}

static void print(const char *key, double value, const char *unit, const char *original) {
    printf(
        "{\"key\":\"%s\",\"value\":%.4g,\"unit\":\"%s\",\"baseline\":%s,\"baseline_value\":%s}\n",
        key, value, unit, original ? "\"original simulator\"" : "null",
        original ? original : "null");
}

static double measure(int copters, const char *original) {
    char key[64];
    csim *sim = make_world(copters);
    csim_run(sim, DIVISOR, DT_US, DIVISOR, DIVISOR);
    double speed = speed_of(sim, copters);
    csim_free(sim);
    snprintf(key, sizeof key, "copter_%d_simsec_per_s", copters);
    print(key, speed, "s/s", original);
    return speed;
}

static void arm_three(fc_context *faults) {
    fc_add_drift(faults, "RollId7", 0.00001, 5);
    fc_add_noise_gauss(faults, "PitchId7", 0.2);
    fc_add_random_offset(faults, "RangeId7Anch2", 0, 0.15);
}

/* The cost of three faults on one of 400 copters, as a part of the cost without. */
static double slowdown(void) {
    csim *plain = make_world(400), *faulted = make_world(400);
    double best_plain = 1e9, best_faulted = 1e9;
    arm_three(csim_faults(faulted));
    for (int slice = 0; slice < 40; slice++) {
        best_plain = fmin(best_plain, slice_s(plain));
        best_faulted = fmin(best_faulted, slice_s(faulted));
    }
    csim_free(plain);
    csim_free(faulted);
    return best_faulted / best_plain - 1;
}

/* MiB: the largest size of this process so far. */
static double resident_mib(void) {
    char line[128];
    double kib = 0;
    FILE *status = fopen("/proc/self/status", "r");
    while (status != NULL && fgets(line, sizeof line, status) != NULL)
        if (strncmp(line, "VmHWM:", 6) == 0)
            sscanf(line + 6, "%lf", &kib);
    if (status != NULL)
        fclose(status);
    return kib / 1024;
}

int main(void) {
    double few = measure(4, "480");
    print("copter_4_us_per_copter_step", DT_US / few / 4, "us", NULL);
    double at_40 = measure(40, "8.6");
    measure(400, "0.0137");
    double at_4000 = measure(4000, NULL);
    print("copter_4000_rss_mib", resident_mib(), "MiB", NULL);
    print("copter_growth_exponent", log(at_40 / at_4000) / log(100), "1", NULL);
    print("copter_faulted_slowdown", slowdown(), "1", NULL);
    return 0;
}
