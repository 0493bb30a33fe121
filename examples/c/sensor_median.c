/* sensor_median.c: what does a median of three redundant sensors hide, and what not?
 *
 * The way of Paper I, section 4.3: a probe stands where each reading enters the program, and the
 * test decides what the probe does. Here the test is a campaign over every bit flip of one sensor
 * and of two sensors. */
#include <faultcheck_wrapper.h>
#include <stdio.h>
#include <stdlib.h>

/* ---- the program under test: a line for each probe is all that is added ---- */

static int median(int a, int b, int c) {
    if (a > b) {
        int larger = a;
        a = b;
        b = larger;
    }
    if (c <= a) {
        return a;
    }
    return c < b ? c : b;
}

static int sensor_evaluate(int s1, int s2, int s3) {
    faultcheck_injectFaultInt("S1val", &s1);
    faultcheck_injectFaultInt("S2val", &s2);
    faultcheck_injectFaultInt("S3val", &s3);
    return median(s1, s2, s3);
}

/* ---- the test ---- */

static const char *const probes[] = {"S1val", "S2val", "S3val"};
enum { SENSORS = 3, BITS = 32, TRUE_VALUE = 101 };

/* How far the result is from the true value, and no less than the worst so far. */
static long long worse(long long worst) {
    long long error = llabs((long long)sensor_evaluate(100, 101, 102) - TRUE_VALUE);
    faultcheck_removeAllFaults();
    return error > worst ? error : worst;
}

static long long one_sensor(void) {
    long long worst = 0;
    for (int sensor = 0; sensor < SENSORS; sensor++) {
        for (int bit = 0; bit < BITS; bit++) {
            faultcheck_addFaultBitFlip(probes[sensor], bit);
            worst = worse(worst);
        }
    }
    return worst;
}

static long long two_sensors(void) {
    long long worst = 0;
    for (int good = 0; good < SENSORS; good++) {
        for (int bits = 0; bits < BITS * BITS; bits++) {
            faultcheck_addFaultBitFlip(probes[(good + 1) % SENSORS], bits / BITS);
            faultcheck_addFaultBitFlip(probes[(good + 2) % SENSORS], bits % BITS);
            worst = worse(worst);
        }
    }
    return worst;
}

int main(void) {
    printf("sensors 100, 101, 102; largest error of their median\n");
    printf("no fault                      %lld\n", worse(0));
    printf("any bit flip in one sensor    %lld\n", one_sensor());
    printf("any bit flip in each of two   %lld\n", two_sensors());
    return 0;
}
