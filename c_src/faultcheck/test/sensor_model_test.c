/* The sensor models (7.6 of the reference), on doubles unless a type matters. Random values come
 * from an independent Python program: the stream of "p", seed 1, ordinal 0. */
#include "errors.h"

#include <math.h>

static fc_context *ctx;

static fc_fault_id arm(int kind, double a, double b, int64_t n) {
    fc_model model = {kind, a, b, n};
    fc_reset(ctx);
    errors_start(ctx);
    return fc_add_model(ctx, "p", &model);
}

static double probe(double value) {
    fc_probe_f64(ctx, "p", &value);
    return value;
}

static int32_t probe_int(int32_t value) {
    fc_probe_i32(ctx, "p", &value);
    return value;
}

static void noise_and_random_offsets(void) {
    const double uniform[4] = {0x1.3c972996c52bbp+3, 0x1.4badeb89c97e3p+3, 0x1.358269ec5ba37p+3,
                               0x1.3cfb593bf683ep+3};
    const double gauss[2] = {0x1.64c0a50187afep+3, 0x1.fd2cf88907f98p+2};
    const double offset[4] = {0x1.b92e532d8a577p+3, 0x1.d75bd71392fc7p+3, 0x1.ab04d3d8b746ep+3,
                              0x1.b9f6b277ed07cp+3};
    arm(FC_NOISE_UNIFORM, 0.5, 0, 0);
    for (int at = 0; at < 4; at++)
        CHECK_BITS(probe(10), uniform[at]);
    arm(FC_NOISE_GAUSS, 2, 0, 0);
    for (int at = 0; at < 2; at++)
        CHECK_BITS(probe(10), gauss[at]);
    arm(FC_RANDOM_OFFSET, 3, 5, 0);
    for (int at = 0; at < 4; at++)
        CHECK_BITS(probe(10), offset[at]);
}

/* The same draws as RANDOM_OFFSET's, each for the calls of two seconds. */
static void held_offsets_stay_for_their_time(void) {
    const double offset[4] = {0x1.b92e532d8a577p+3, 0x1.d75bd71392fc7p+3, 0x1.ab04d3d8b746ep+3,
                              0x1.b9f6b277ed07cp+3};
    arm(FC_HELD_OFFSET, 3, 5, 2000000000);
    fc_advance(ctx, 700000000); /* the periods begin with the first call */
    CHECK_BITS(probe(10), offset[0]);
    CHECK_BITS(probe(10), offset[0]);
    fc_advance(ctx, 1999999999);
    CHECK_BITS(probe(10), offset[0]);
    CHECK_INT(probe_int(10), 13); /* all types share it */
    fc_advance(ctx, 1);
    CHECK_BITS(probe(10), offset[1]);
    fc_advance(ctx, 2000000000);
    CHECK_BITS(probe(10), offset[2]);
    fc_advance(ctx, 19500000000); /* one draw, however many periods were missed */
    CHECK_BITS(probe(10), offset[3]);
    fc_fault_id fault = arm(FC_HELD_OFFSET, 3, 5, 1000000000);
    fc_trigger_periodic(ctx, fault, 2, 1);
    CHECK_BITS(probe(10), offset[0]);
    CHECK_BITS(probe(10), 10);
    CHECK_BITS(probe(10), offset[1]); /* a new window */
}

static void drift_grows_within_a_window(void) {
    fc_fault_id fault = arm(FC_DRIFT, 0.5, 1.25, 0);
    CHECK_BITS(probe(10), 10.5);
    CHECK_BITS(probe(10), 11);
    CHECK_BITS(probe(10), 11.25);
    fc_trigger_periodic(ctx, fault, 3, 2); /* an unaffected call ends the window */
    CHECK_BITS(probe(10), 10.5);
    CHECK_BITS(probe(10), 11);
    CHECK_BITS(probe(10), 10);
    CHECK_BITS(probe(10), 10.5);
    arm(FC_DRIFT, -1, INFINITY, 0);
    CHECK_INT(probe_int(10), 9);
    CHECK_INT(probe_int(10), 8);
}

static void timed_drift_counts_seconds_of_the_window(void) {
    fc_fault_id fault = arm(FC_DRIFT_TIMED, 2, 5, 0);
    fc_advance(ctx, 1000000000);
    CHECK_BITS(probe(10), 10);
    fc_advance(ctx, 1500000000);
    CHECK_BITS(probe(10), 13);
    fc_advance(ctx, 1500000000);
    CHECK_BITS(probe(10), 15);
    fc_trigger_after(ctx, fault, 0);
    CHECK_BITS(probe(10), 10);
}

static void ramp_goes_from_the_first_value_to_the_target(void) {
    arm(FC_RAMP, 20, 0, 4);
    CHECK_BITS(probe(10), 12.5);
    CHECK_BITS(probe(-5), 15); /* the way does not depend on later inputs */
    CHECK_BITS(probe(0), 17.5);
    CHECK_BITS(probe(0), 20);
    CHECK_BITS(probe(99), 20);
    arm(FC_RAMP, 20, 0, 1);
    CHECK_BITS(probe(10), 20);
}

static void delay_hands_out_old_inputs(void) {
    arm(FC_DELAY, 0, 0, 2);
    for (int at = 1; at <= 6; at++)
        CHECK_INT(probe_int(at), at <= 2 ? 1 : at - 2);
    arm(FC_DELAY, 0, 0, 2);
    for (int at = 0; at < 6; at++) { /* per type */
        CHECK_BITS(probe(at + 0.5), at < 2 ? 0.5 : at - 1.5);
        CHECK_INT(probe_int(at), at < 2 ? 0 : at - 2);
    }
    arm(FC_DELAY, 0, 0, 0);
    CHECK_INT(probe_int(7), 7);
}

static void quantise_dead_zone_saturate(void) {
    arm(FC_QUANTISE, 0.25, 0, 0);
    CHECK_BITS(probe(1.1), 1);
    CHECK_BITS(probe(1.125), 1.25);
    CHECK_BITS(probe(-1.2), -1.25);
    arm(FC_QUANTISE, 10, 0, 0);
    CHECK_INT(probe_int(17), 20);
    arm(FC_DEAD_ZONE, 5, 2, 0);
    CHECK_BITS(probe(6.9), 5);
    CHECK_BITS(probe(7), 7);
    CHECK_BITS(probe(3.1), 5);
    CHECK_BITS(probe(3), 3);
    arm(FC_SATURATE, -1, 2, 0);
    CHECK_BITS(probe(-7), -1);
    CHECK_BITS(probe(1.5), 1.5);
    CHECK_BITS(probe(7), 2);
    CHECK(isnan(probe(NAN)));
}

/* 3 * sin(2 pi k / 12) by hand: 0, 1/2, sqrt(3)/2, 1, ... times 3. */
static void oscillation_is_a_sine(void) {
    const double half = 1.5, high = 3 * 0.8660254037844386;
    const double expected[13] = {0,     half,  high, 3,     high,  half, 0,
                                 -half, -high, -3,   -high, -half, 0};
    arm(FC_OSCILLATE, 3, 0, 12);
    for (int k = 0; k < 13; k++)
        CHECK(fabs(probe(10) - (10 + expected[k])) < 4e-15);
    arm(FC_OSCILLATE, 1, 0, 1000);
    for (int k = 0; k < 2000; k++) /* against the C library */
        CHECK(fabs(probe(0) - sin(2 * 3.14159265358979323846 * k / 1000)) < 2e-14);
}

static void dropouts_hold_zero_or_spoil(void) {
    const char *hits = "1011011001100111"; /* unit() < 0.5 */
    double last = 1;
    fc_fault_id fault = arm(FC_DROPOUT, 0.5, 0, FC_HOLD);
    for (int at = 1; hits[at - 1] != '\0'; at++) {
        if (hits[at - 1] == '0')
            last = at;
        CHECK_BITS(probe(at), last);
    }
    CHECK_INT(fc_trigger_after(ctx, fault, 0), FC_OK);
    arm(FC_DROPOUT, 1, 0, FC_HOLD);
    CHECK_BITS(probe(5), 5); /* nothing got through: the first input */
    CHECK_BITS(probe(6), 5);
    arm(FC_DROPOUT, 1, 0, FC_ZERO);
    CHECK_BITS(probe(5), 0);
    CHECK_INT(probe_int(5), 0);
    arm(FC_DROPOUT, 1, 0, FC_NAN);
    CHECK(isnan(probe(5)));
    CHECK_INT(probe_int(5), 5);
    CHECK_ERROR(FC_E_TYPE, "i32");
    arm(FC_DROPOUT, 0, 0, FC_NAN);
    CHECK_BITS(probe(5), 5);
}

static void spikes_go_up_or_down(void) {
    const double expected[10] = {-99, 101, 1, 101, 1, 1, 101, 1, 1, 101};
    arm(FC_SPIKE, 0.5, 100, 0);
    for (int at = 0; at < 10; at++)
        CHECK_BITS(probe(1), expected[at]);
}

static void stuck_bits_are_forced(void) {
    arm(FC_STUCK_BIT, 1, 0, 3);
    CHECK_INT(probe_int(0), 8);
    CHECK_INT(probe_int(8), 8);
    arm(FC_STUCK_BIT, 0, 0, 31);
    CHECK_INT(probe_int(-1), INT32_MAX);
    arm(FC_STUCK_BIT, 0, 0, 63);
    CHECK_BITS(probe(-1.5), 1.5);
    CHECK_INT(probe_int(5), 5);
    CHECK_ERROR(FC_E_BIT, "no bit 63");
    bool truth = false;
    arm(FC_STUCK_BIT, 1, 0, 0);
    fc_probe_bool(ctx, "p", &truth);
    CHECK_INT(truth, true);
    unsigned char bytes[2] = {0, 0};
    arm(FC_STUCK_BIT, 1, 0, 15);
    fc_probe_bytes(ctx, "p", bytes, 2);
    CHECK_INT(bytes[1], 0x80);
}

static void whole_contents_of_bytes_are_delayed(void) {
    char data[3][4] = {"abc", "def", "ghi"};
    arm(FC_DELAY, 0, 0, 1);
    for (int at = 0; at < 3; at++)
        CHECK_INT(fc_probe_bytes(ctx, "p", data[at], 3), FC_OK);
    CHECK(strcmp(data[0], "abc") == 0);
    CHECK(strcmp(data[1], "abc") == 0);
    CHECK(strcmp(data[2], "def") == 0);
    arm(FC_NOISE_GAUSS, 1, 0, 0);
    CHECK_INT(fc_probe_bytes(ctx, "p", data[0], 3), FC_E_TYPE);
    CHECK_ERROR(FC_E_TYPE, "bytes");
}

static void integers_convert_and_saturate(void) {
    int8_t small = 100;
    arm(FC_DRIFT, 50, INFINITY, 0);
    fc_probe_i8(ctx, "p", &small);
    CHECK_INT(small, 127);
    arm(FC_RAMP, 0.9, 0, 1);
    CHECK_INT(probe_int(5), 0);
}

static void parameters_are_checked(void) {
    const fc_model bad[] = {
        {FC_STUCK_BIT, 2, 0, 0},     {FC_NOISE_UNIFORM, NAN, 0, 0}, {FC_NOISE_GAUSS, NAN, 0, 0},
        {FC_RANDOM_OFFSET, 2, 1, 0}, {FC_DRIFT, 1, -1, 0},          {FC_DRIFT_TIMED, NAN, 1, 0},
        {FC_RAMP, 1, 0, 0},          {FC_DELAY, 0, 0, -1},          {FC_QUANTISE, 0, 0, 0},
        {FC_DEAD_ZONE, NAN, 1, 0},   {FC_SATURATE, 2, 1, 0},        {FC_OSCILLATE, 1, 0, 0},
        {FC_DROPOUT, 1.1, 0, 0},     {FC_DROPOUT, 1, 0, 3},         {FC_HELD_OFFSET, 2, 1, 1},
        {FC_HELD_OFFSET, 1, 2, 0},   {FC_SPIKE, -0.1, 0, 0},        {77, 0, 0, 0}};
    for (size_t at = 0; at < sizeof bad / sizeof bad[0]; at++) {
        CHECK_INT(arm(bad[at].kind, bad[at].a, bad[at].b, bad[at].n), FC_E_ARG);
        CHECK_ERROR(FC_E_ARG, "not added");
        CHECK_INT(probe_int(5), 5);
    }
    CHECK_INT(arm(FC_BITFLIP, 0, 0, -1), FC_E_BIT);
    CHECK_INT(arm(FC_STUCK_BIT, 0, 0, -1), FC_E_BIT);
    errors_start(ctx);
    CHECK_INT(fc_add_model(ctx, "p", NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "NULL");
}

/* The functions model by model arm what their names say. */
static void the_functions_pass_their_parameters(void) {
    fc_reset(ctx);
    CHECK(fc_add_stuck_bit(ctx, "1", 2, true) > 0);
    CHECK(fc_add_noise_uniform(ctx, "2", 0) > 0);
    CHECK(fc_add_noise_gauss(ctx, "3", 0) > 0);
    CHECK(fc_add_random_offset(ctx, "4", 7, 7) > 0);
    CHECK(fc_add_drift(ctx, "5", 9, 3) > 0);
    CHECK(fc_add_drift_timed(ctx, "6", 9, 3) > 0);
    CHECK(fc_add_ramp(ctx, "7", 30, 2) > 0);
    CHECK(fc_add_delay(ctx, "8", 1) > 0);
    CHECK(fc_add_quantise(ctx, "9", 8) > 0);
    CHECK(fc_add_dead_zone(ctx, "10", 12, 3) > 0);
    CHECK(fc_add_saturate(ctx, "11", 1, 2) > 0);
    CHECK(fc_add_oscillate(ctx, "12", 5, 4) > 0);
    CHECK(fc_add_dropout(ctx, "13", 1, FC_ZERO) > 0);
    CHECK(fc_add_spike(ctx, "14", 1, 0) > 0);
    CHECK(fc_add_held_offset(ctx, "15", 6, 6, 1) > 0);
    const int expected[15] = {14, 10, 10, 17, 13, 10, 20, 10, 8, 12, 2, 10, 0, 10, 16};
    for (int at = 0; at < 15; at++) {
        char id[3];
        int32_t value = 10;
        snprintf(id, sizeof id, "%d", at + 1);
        fc_probe_i32(ctx, id, &value);
        CHECK_INT(value, expected[at]);
    }
}

int main(void) {
    ctx = fc_new(NULL);
    noise_and_random_offsets();
    held_offsets_stay_for_their_time();
    drift_grows_within_a_window();
    timed_drift_counts_seconds_of_the_window();
    ramp_goes_from_the_first_value_to_the_target();
    delay_hands_out_old_inputs();
    quantise_dead_zone_saturate();
    oscillation_is_a_sine();
    dropouts_hold_zero_or_spoil();
    spikes_go_up_or_down();
    stuck_bits_are_forced();
    whole_contents_of_bytes_are_delayed();
    integers_convert_and_saturate();
    parameters_are_checked();
    the_functions_pass_their_parameters();
    fc_free(ctx);
    return CHECK_RESULT();
}
