/* copter_drift.c: how wrong may an accelerometer be?
 *
 * A quadcopter hovers between four anchors and locates itself by dead reckoning and by ranging to
 * them. Its accelerometer is misaligned, which libfaultcheck plays: an offset on the tilt that the
 * copter perceives. Prints how far the copter came to be from where it believed to be, with and
 * without ranging. */
#include <csim.h>
#include <stdio.h>
#include <stdlib.h>

enum { COPTER = 0, STEP_US = 5000, STEPS = 4000, EVERY = 20 };

static void must(int result) {
    if (result < 0) {
        fprintf(stderr, "copter_drift: %s\n", csim_last_error_text());
        exit(1);
    }
}

/* The largest distance between the true and the perceived position, in m, in 20 s. */
static double largest_error_m(double misaligned_deg, bool ranging) {
    csim *sim = csim_new(NULL);
    csim_station station;
    if (sim == NULL) {
        fprintf(stderr, "copter_drift: %s\n", csim_last_error_text());
        exit(1);
    }
    must(csim_add_copter(sim, COPTER, 0, 0, 30));
    if (ranging) {
        must(csim_add_anchor(sim, 0, -8, -5, 1));
        must(csim_add_anchor(sim, 1, -8, 5, 1));
        must(csim_add_anchor(sim, 2, 8, 5, 1));
        must(csim_add_anchor(sim, 3, 8, -5, 1));
    }
    if (fc_add_offset(csim_faults(sim), "PitchId0", misaligned_deg) < 0) {
        fprintf(stderr, "copter_drift: %s\n", fc_last_error_text());
        exit(1);
    }
    must(csim_run(sim, STEPS, STEP_US, EVERY, EVERY));
    must(csim_override(sim, COPTER, &station));
    csim_free(sim);
    return station.max_pos_error;
}

int main(void) {
    printf("misaligned by   with ranging   dead reckoning alone\n");
    for (int halves = 0; halves <= 6; halves++) {
        double misaligned_deg = 0.5 * halves;
        printf("%9.1f deg %12.2f m %18.1f m\n", misaligned_deg,
               largest_error_m(misaligned_deg, true), largest_error_m(misaligned_deg, false));
    }
    return 0;
}
