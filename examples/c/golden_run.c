/* golden_run.c: how far does an error travel?
 *
 * Records a run without faults (the golden run) and one with a fault, and compares them: which
 * value went wrong first, which followed, and by how much. The program under test is a cruise
 * control with a car; monitors watch what the probe does not touch. */
#include <fc.h>
#include <stdio.h>
#include <stdlib.h>

/* ---- the program under test ---- */

static double throttle(double wanted_kmh, double measured_kmh, double *integral) {
    double error = wanted_kmh - measured_kmh;
    *integral += 0.002 * error;
    double demand = 0.05 * error + *integral;
    return demand < 0 ? 0 : demand > 1 ? 1 : demand;
}

/* 200 steps of 0.1 s; every value on the way is named. */
static void drive(fc_context *ctx) {
    double speed_kmh = 60;
    double integral = 0.4;
    for (int step = 0; step < 200; step++) {
        double measured = speed_kmh;
        fc_probe_f64(ctx, "1 measured speed", &measured);
        double position = throttle(80, measured, &integral);
        fc_monitor_f64(ctx, "2 throttle", position);
        speed_kmh += 0.1 * (12 * position - 0.06 * speed_kmh);
        fc_monitor_f64(ctx, "3 speed", speed_kmh);
        fc_monitor_bool(ctx, "4 too fast", speed_kmh > 90);
    }
}

/* ---- the test ---- */

typedef struct {
    void *bytes;
    size_t length;
} recording;

/* Drives once and keeps what was recorded. */
static recording recorded_drive(fc_context *ctx) {
    recording made = {NULL, 0};
    fc_record_start(ctx, NULL);
    drive(ctx);
    fc_record_stop(ctx);
    made.length = fc_record_copy(ctx, NULL, 0);
    made.bytes = malloc(made.length);
    if (made.bytes == NULL) {
        fprintf(stderr, "golden_run: no memory for %zu bytes\n", made.length);
        exit(1);
    }
    fc_record_copy(ctx, made.bytes, made.length);
    return made;
}

static void print_divergence(void *user, const fc_divergence *found) {
    (void)user;
    printf("  %-18s  step %3llu  %3llu steps  %8.2f\n", found->id, (unsigned long long)found->first,
           (unsigned long long)found->differing, found->largest_absolute);
}

static void compare_with(fc_context *ctx, recording golden, const char *fault) {
    static const fc_tolerance tolerance = {1e-9, 0};
    recording run = recorded_drive(ctx);
    printf("%s\n  %-18s  %-8s  %-9s  %8s\n", fault, "value", "first", "differs", "by up to");
    int differ = fc_compare(golden.bytes, golden.length, run.bytes, run.length, &tolerance,
                            print_divergence, NULL);
    printf("  %d of 4 values differ\n", differ);
    free(run.bytes);
    fc_reset(ctx);
}

int main(void) {
    fc_context *ctx = fc_new(NULL);
    if (ctx == NULL) {
        return 1;
    }
    recording golden = recorded_drive(ctx);
    fc_reset(ctx);

    /* Steps 100..119 show what step 100 showed. The car has almost settled: little happens. */
    fc_fault_id fault = fc_add_stuck(ctx, "1 measured speed");
    fc_trigger_after(ctx, fault, 100);
    fc_trigger_duration(ctx, fault, 20);
    compare_with(ctx, golden, "speed stuck, steps 100 to 119");

    fault = fc_add_offset(ctx, "1 measured speed", -15);
    fc_trigger_after(ctx, fault, 100);
    compare_with(ctx, golden, "15 km/h too low from step 100 on");

    free(golden.bytes);
    fc_free(ctx);
    return 0;
}
