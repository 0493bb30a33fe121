/* The triggers beside the iteration window, alone and together (7.5 of the reference). */
#include "errors.h"

#include <math.h>

static fc_context *ctx;

static void start(void) {
    fc_reset(ctx);
    errors_start(ctx);
}

/* '1' for each affected one of the next calls. */
static const char *calls(int count) {
    static char seen[100];
    for (int at = 0; at < count; at++) {
        int32_t value = 0;
        fc_probe_i32(ctx, "p", &value);
        seen[at] = value != 0 ? '1' : '0';
    }
    seen[count] = '\0';
    return seen;
}

#define CHECK_CALLS(expected)                                                                      \
    do {                                                                                           \
        const char *check_seen = calls((int)strlen(expected));                                     \
        if (strcmp(check_seen, expected) != 0) {                                                   \
            check_failures++;                                                                      \
            fprintf(stderr, "%s:%d: %s, expected %s\n", __FILE__, __LINE__, check_seen, expected); \
        }                                                                                          \
    } while (0)

static fc_fault_id arm(void) {
    return fc_add_set_to(ctx, "p", 1);
}

static void time_windows_follow_the_manual_clock(void) {
    start();
    fc_fault_id fault = arm();
    fc_advance(ctx, 1000);
    CHECK_INT(fc_trigger_time(ctx, fault, 100, 50), FC_OK);
    CHECK_CALLS("00");
    fc_advance(ctx, 99);
    CHECK_CALLS("0");
    fc_advance(ctx, 1);
    CHECK_CALLS("11");
    fc_advance(ctx, 49);
    CHECK_CALLS("1");
    fc_advance(ctx, 1);
    CHECK_CALLS("00");
    CHECK_INT(fc_trigger_time(ctx, fault, 10, -1), FC_OK);
    CHECK_CALLS("0");
    fc_advance(ctx, INT64_C(1000000000000));
    CHECK_CALLS("11");
    CHECK_INT(fc_now(ctx), INT64_C(1000000001150));
    fc_reset(ctx);
    CHECK_INT(fc_now(ctx), 0);
}

static int64_t own_time;
static int64_t own_clock(void *user) {
    return *(int64_t *)user;
}

static void a_clock_can_be_given(void) {
    start();
    fc_set_clock(ctx, own_clock, &own_time);
    own_time = 500;
    CHECK_INT(fc_now(ctx), 500);
    fc_trigger_time(ctx, arm(), 0, 10);
    CHECK_CALLS("11");
    own_time = 510;
    CHECK_CALLS("00");
    fc_set_clock(ctx, NULL, NULL);
    int64_t before = fc_now(ctx);
    CHECK(fc_now(ctx) >= before);
}

static void periodic_calls(void) {
    start();
    fc_fault_id fault = arm();
    CHECK_INT(fc_trigger_periodic(ctx, fault, 4, 2), FC_OK);
    CHECK_CALLS("1100110011");
    fc_trigger_after(ctx, fault, 3); /* k is 0 at the first call after the delay */
    CHECK_CALLS("0001100110");
    fc_trigger_duration(ctx, fault, 3); /* affected calls only */
    CHECK_CALLS("0110010000");
    CHECK_INT(fc_trigger_periodic(ctx, fault, 4, 0), FC_OK);
    fc_trigger_duration(ctx, fault, -1);
    CHECK_CALLS("00000");
}

static bool gate;
static int asked;
static bool is_open(void *user) {
    asked++;
    /* Callbacks run without any lock held, so they may use the library, also the same identifier.
     */
    fc_num_active(ctx, "p");
    fc_trigger_duration(ctx, fc_latest(ctx, "p"), -1);
    return *(bool *)user;
}

static void predicates_gate_calls(void) {
    start();
    fc_fault_id fault = arm();
    CHECK_INT(fc_trigger_when(ctx, fault, is_open, &gate), FC_OK);
    gate = false;
    asked = 0;
    CHECK_CALLS("000");
    CHECK_INT(asked, 3);
    gate = true;
    CHECK_CALLS("11");
    fc_trigger_none(ctx, fault);
    gate = false;
    CHECK_CALLS("11");
    CHECK_INT(asked, 5);
}

/* Expected hits from an independent Python program: unit() < 0.3 of the stream of "p", seed 1,
 * ordinal 0. */
static void random_triggers_draw_from_the_stream(void) {
    start();
    fc_fault_id fault = arm();
    CHECK_INT(fc_trigger_random(ctx, fault, 0.3), FC_OK);
    CHECK_CALLS("00100000000001000101");
    start();
    fault = arm();
    fc_trigger_random(ctx, fault, 0.3);
    fc_trigger_periodic(ctx, fault, 2, 1); /* no draw is made while another trigger does not hold */
    CHECK_CALLS("00001000000000000000");
    start();
    fc_trigger_random(ctx, arm(), 0);
    CHECK_CALLS("00000000");
    start();
    fc_trigger_random(ctx, arm(), 1);
    CHECK_CALLS("11111111");
}

static void bad_triggers_change_nothing(void) {
    start();
    fc_fault_id fault = arm();
    CHECK_INT(fc_trigger_time(ctx, fault, -1, 5), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "delay");
    CHECK_INT(fc_trigger_random(ctx, fault, 1.5), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "probability");
    CHECK_INT(fc_trigger_random(ctx, fault, NAN), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "probability");
    CHECK_INT(fc_trigger_periodic(ctx, fault, 0, 5), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "period");
    CHECK_INT(fc_trigger_when(ctx, fault, NULL, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "predicate");
    CHECK_INT(fc_trigger_none(ctx, 99), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "99");
    CHECK_CALLS("111");
}

static void disabled_triggers_stand_still(void) {
    start();
    fc_fault_id fault = arm();
    fc_trigger_periodic(ctx, fault, 2, 1);
    CHECK_CALLS("10");
    fc_enable(ctx, fault, false);
    CHECK_CALLS("000");
    fc_enable(ctx, fault, true);
    CHECK_CALLS("101");
}

int main(void) {
    ctx = fc_new(NULL);
    time_windows_follow_the_manual_clock();
    a_clock_can_be_given();
    periodic_calls();
    predicates_gate_calls();
    random_triggers_draw_from_the_stream();
    bad_triggers_change_nothing();
    disabled_triggers_stand_still();
    fc_free(ctx);
    return CHECK_RESULT();
}
