/* Probes and their faults: windows, order, arithmetic. Expected values are worked out by hand. */
#include "check.h"
#include "fi.h"
#include "fi_replies.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>

static void start(void) {
    fi_init();
    fi_run("fi_set_enabled 1");
}

static void ok(const char *line) {
    fi_run(line);
    if (strcmp(fi_last.text, "ok\n") != 0) {
        check_failures++;
        fprintf(stderr, "%s: %s", line, fi_last.text);
    }
}

static int probe_int(int value) {
    fi_inject_fault_int("p", &value);
    return value;
}

static double probe_float(float value) {
    fi_inject_fault_float("p", &value);
    return value;
}

/* The first `calls` calls with 0: a bit for each that a fault of +1 affected, the first call the
 * lowest. */
static unsigned affected(int calls) {
    unsigned bits = 0;
    for (int i = 0; i < calls; i++)
        bits |= (unsigned)probe_int(0) << i;
    return bits;
}

static void off_after_init_and_nothing_is_counted_while_off(void) {
    fi_init();
    CHECK(!fi_is_active());
    ok("fi_add_fault p OFFSET 1 1 1");
    CHECK_INT(affected(3), 0);
    ok("fi_set_enabled 1");
    CHECK(fi_is_active());
    CHECK_INT(affected(1), 0);
    ok("fi_set_enabled 0");
    CHECK_INT(affected(3), 0);
    ok("fi_set_enabled 1");
    CHECK_INT(affected(3), 1);
    fi_init();
    CHECK(!fi_is_active());
    CHECK_INT(affected(3), 0);
}

static void a_fault_is_active_from_its_start_for_its_duration(void) {
    start();
    ok("fi_add_fault p OFFSET 1 2 3");
    CHECK_INT(affected(8), 0x1c);
    start();
    CHECK_INT(affected(5), 0); /* no fault yet: not counted */
    ok("fi_add_fault p OFFSET 1 3 0");
    CHECK_INT(affected(8), 0xf8);
    ok("fi_add_fault p OFFSET 2 1 1"); /* counted from now */
    CHECK_INT(probe_int(0), 1);
    CHECK_INT(probe_int(0), 3);
    CHECK_INT(probe_int(0), 1);
}

/* The example of the reference: ((0^4)+23)^2048. */
static void faults_apply_in_the_order_of_adding(void) {
    start();
    ok("fi_add_fault p BITFLIP 2 0 0");
    ok("fi_add_fault p OFFSET 23 0 0");
    ok("fi_add_fault p BITFLIP 11 0 0");
    CHECK_INT(probe_int(0), 2075);
}

static void integers_are_computed_in_double_truncated_and_saturated(void) {
    start();
    ok("fi_add_fault p OFFSET 0.5 0 1");
    ok("fi_add_fault p AMPLIFICATION -1.5 1 1");
    ok("fi_add_fault p SET_TO -1.9 2 1");
    ok("fi_add_fault p AMPLIFICATION 1 3 1");
    ok("fi_add_fault p OFFSET 1 4 1");
    CHECK_INT(probe_int(-1), 0);
    CHECK_INT(probe_int(3), -4);
    CHECK_INT(probe_int(7), -1);
    CHECK_INT(probe_int(16777217), 16777217); /* no float holds this number */
    CHECK_INT(probe_int(123456789), 123456790);
    start();
    ok("fi_add_fault p OFFSET 3e38 0 1");
    ok("fi_add_fault p AMPLIFICATION -3e38 1 2");
    ok("fi_add_fault p OFFSET -1 3 1");
    ok("fi_add_fault p OFFSET 1 4 1");
    CHECK_INT(probe_int(5), INT_MAX);
    CHECK_INT(probe_int(5), INT_MIN);
    CHECK_INT(probe_int(-5), INT_MAX);
    CHECK_INT(probe_int(INT_MIN), INT_MIN);
    CHECK_INT(probe_int(INT_MAX), INT_MAX);
}

static void bits_of_integers_and_floats(void) {
    start();
    ok("fi_add_fault p BITFLIP 31 0 2");
    ok("fi_add_fault p BITFLIP 0.99 2 1"); /* truncated: 0 */
    ok("fi_add_fault p BITFLIP -7 3 1");   /* clamped: 0 */
    ok("fi_add_fault p BITFLIP 1e9 4 1");  /* clamped: 31 */
    ok("fi_add_fault p BITFLIP 31.9 5 1");
    CHECK_INT(probe_int(0), INT_MIN);
    CHECK_BITS(probe_float(1.5f), -1.5);
    CHECK_BITS(probe_float(0), 0x1p-149);
    CHECK_INT(probe_int(6), 7);
    CHECK_INT(probe_int(0), INT_MIN);
    CHECK_INT(probe_int(-1), INT_MAX);
}

static void floats_are_those_of_ieee_754(void) {
    start();
    ok("fi_add_fault p OFFSET 1 0 2");
    ok("fi_add_fault p AMPLIFICATION 2 2 3");
    ok("fi_add_fault p AMPLIFICATION 0.1 5 1");
    ok("fi_add_fault p SET_TO -0 6 1");
    CHECK_BITS(probe_float(16777216.0f), 16777216.0); /* a tie, to even */
    CHECK(isnan(probe_float(NAN)));
    CHECK_BITS(probe_float(FLT_MAX), INFINITY);
    CHECK_BITS(probe_float(-0.0f), -0.0);
    CHECK_BITS(probe_float(0x1p-149f), 0x1p-148);
    CHECK_BITS(probe_float(3.0f), 0x1.333334p-2); /* 3 * 0x1.99999ap-4, rounded up */
    CHECK_BITS(probe_float(3.0f), -0.0);
}

static void none_counts_and_does_nothing(void) {
    float nan = 0;
    const uint32_t signalling = 0x7f800001;
    uint32_t after;
    start();
    ok("fi_add_fault p nOnE 0 0 0");
    CHECK_INT(probe_int(12), 12);
    memcpy(&nan, &signalling, sizeof nan);
    fi_inject_fault_float("p", &nan);
    memcpy(&after, &nan, sizeof after);
    CHECK_INT(after, signalling);
    fi_run("fi_print_faults");
    CHECK(strstr(fi_last.text, "probe=p it=2 type=NONE") != NULL);
}

static void other_identifiers_are_unchanged(void) {
    static const char *const others[] = {
        "", "P", "pp", "p ", "aaaaaaaaaaaaaaaaaaaaa", "aaaaaaaaaaaaaaaaaaa", NULL};
    start();
    ok("fi_add_fault p OFFSET 1 0 0");
    ok("fi_add_fault aaaaaaaaaaaaaaaaaaaa OFFSET 1 0 0");
    for (int i = 0; i < 7; i++) {
        int value = 3;
        fi_inject_fault_int(others[i], &value);
        CHECK_INT(value, 3);
    }
    int value = 3;
    fi_inject_fault_int("aaaaaaaaaaaaaaaaaaaa", &value);
    CHECK_INT(value, 4);
    fi_inject_fault_int("p", NULL);
    fi_inject_fault_float("p", NULL);
    CHECK_INT(probe_int(1), 2);
}

/* A probe of either type is one call of the identifier. */
static void types_share_faults_and_counter(void) {
    start();
    ok("fi_add_fault p OFFSET 1 1 2");
    CHECK_INT(probe_int(1), 1);
    CHECK_BITS(probe_float(1), 2);
    CHECK_INT(probe_int(1), 2);
    CHECK_BITS(probe_float(1), 1);
}

static void clear_removes_faults_zeroes_counters_and_keeps_the_switch(void) {
    start();
    ok("fi_add_fault p OFFSET 1 0 0");
    CHECK_INT(affected(2), 3);
    ok("fi_clear_faults");
    CHECK(fi_is_active());
    CHECK_INT(affected(2), 0);
    ok("fi_add_fault p OFFSET 1 1 1");
    fi_run("fi_print_faults");
    CHECK(strstr(fi_last.text, " it=0 ") != NULL && strstr(fi_last.text, " start=1 ") != NULL);
    CHECK_INT(affected(3), 2);
}

static void reset_brings_a_used_fault_back(void) {
    start();
    ok("fi_add_fault p OFFSET 1 1 1");
    CHECK_INT(affected(4), 2);
    ok("fi_reset_cnt");
    CHECK_INT(affected(4), 2);
    ok("fi_add_fault p OFFSET 1 0 1"); /* call 4 from the reset on */
    ok("fi_reset_cnt");
    CHECK_INT(affected(6), 0x12);
}

int main(void) {
    off_after_init_and_nothing_is_counted_while_off();
    a_fault_is_active_from_its_start_for_its_duration();
    faults_apply_in_the_order_of_adding();
    integers_are_computed_in_double_truncated_and_saturated();
    bits_of_integers_and_floats();
    floats_are_those_of_ieee_754();
    none_counts_and_does_nothing();
    other_identifiers_are_unchanged();
    types_share_faults_and_counter();
    clear_removes_faults_zeroes_counters_and_keeps_the_switch();
    reset_brings_a_used_fault_back();
    return CHECK_RESULT();
}
