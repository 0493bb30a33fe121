/* Where the original was wrong or undefined: each row of section 5 of the reference, with its
 * error. */
#include "errors.h"
#include "faultcheck_packet_wrapper.h"
#include "faultcheck_wrapper.h"

#include <limits.h>
#include <math.h>

static int probe(int value) {
    faultcheck_injectFaultInt("p", &value);
    return value;
}

static double probe_double(double value) {
    faultcheck_injectFaultDouble("p", &value);
    return value;
}

static void start(void) {
    fc_reset(NULL);
    errors_start(NULL);
}

static void row_1_stuck_holds_per_type_and_window(void) {
    start();
    faultcheck_addFaultStuckToCurrent("p");
    CHECK_INT(probe(11), 11);
    CHECK_INT(probe(22), 11);
    CHECK_BITS(probe_double(0.5), 0.5);
    CHECK_BITS(probe_double(1.5), 0.5);
    CHECK_INT(probe(33), 11);

    start();
    faultcheck_addFaultStuckToCurrent("p");
    faultcheck_setDurationAfterTrigger("p", 2);
    CHECK_INT(probe(11), 11);
    CHECK_INT(probe(22), 11);
    CHECK_INT(probe(33), 33);
    faultcheck_setDurationAfterTrigger("p", 2);
    CHECK_INT(probe(44), 44); /* a new window captures anew */
    CHECK_INT(probe(55), 44);
    faultcheck_setDurationAfterTrigger("p", -1); /* so does a changed trigger */
    CHECK_INT(probe(66), 66);
    CHECK_INT(probe(77), 66);
    CHECK_NO_ERROR();
}

static void row_2_ints_saturate(void) {
    start();
    faultcheck_addFaultOffset("p", 1e10);
    CHECK_INT(probe(5), INT_MAX);
    start();
    faultcheck_addFaultAmplification("p", -1e10);
    CHECK_INT(probe(5), INT_MIN);
    start();
    faultcheck_addFaultSetTo("p", INFINITY);
    CHECK_INT(probe(5), INT_MAX);
    start();
    faultcheck_addFaultSetTo("p", -2147483648.9); /* in range: truncates to the limit */
    CHECK_INT(probe(5), INT_MIN);
    start();
    faultcheck_addFaultSetTo("p", 2147483647.9);
    CHECK_INT(probe(5), INT_MAX);
    CHECK_NO_ERROR();
    start();
    faultcheck_addFaultSetTo("p", NAN);
    CHECK_INT(probe(5), 5);
    CHECK_ERROR(FC_E_VALUE, "\"p\"");
    CHECK(isnan(probe_double(5)));
    CHECK_NO_ERROR();
}

static void row_3_bit_indexes_are_checked(void) {
    start();
    faultcheck_addFaultBitFlip("p", -1);
    CHECK_ERROR(FC_E_BIT, "0..63");
    faultcheck_addFaultBitFlip("p", 64);
    CHECK_ERROR(FC_E_BIT, "0..63");
    CHECK_INT(probe(5), 5);
    faultcheck_addFaultBitFlip("p", 32);
    faultcheck_setDurationAfterTrigger("p", 2);
    CHECK_NO_ERROR();
    CHECK_INT(probe(5), 5);
    CHECK_INT(errors_first, 1);
    CHECK_ERROR(FC_E_BIT, "no bit 32");
    CHECK_INT(probe(5), 5); /* the trigger advanced, the cause is not new */
    CHECK_INT(errors_first, 0);
    CHECK_ERROR(FC_E_BIT, "no bit 32");
    CHECK_BITS(probe_double(1), 1); /* used up by the two calls above */
}

static void row_4_each_bit_of_a_double_flips_alone(void) {
    for (int bit = 0; bit < 64; bit++) {
        double in = 1.375;
        unsigned long long before, after;
        start();
        faultcheck_addFaultBitFlip("p", bit);
        double out = probe_double(in);
        memcpy(&before, &in, 8);
        memcpy(&after, &out, 8);
        CHECK((before ^ after) == 1ULL << bit);
    }
}

static void row_5_random_flips_reach_every_bit(void) {
    unsigned long long reached = 0;
    unsigned reached_int = 0;
    start();
    faultcheck_addFaultBitFlipRandom("p");
    for (int call = 0; call < 2000; call++) {
        double out = probe_double(0);
        unsigned long long bits;
        unsigned flipped = (unsigned)probe(0);
        memcpy(&bits, &out, 8);
        CHECK(bits != 0 && (bits & (bits - 1)) == 0);
        CHECK(flipped != 0 && (flipped & (flipped - 1)) == 0);
        reached |= bits;
        reached_int |= flipped;
    }
    CHECK(reached == ~0ULL);
    CHECK(reached_int == ~0U);
}

static void row_7_delays_are_64_bits_wide(void) {
    const unsigned long delays[] = {1UL << 31, 1UL << 32, (1UL << 32) + 2, ~0UL};
    for (int at = 0; at < 4; at++) {
        start();
        faultcheck_addFaultOffset("p", 1);
        faultcheck_setTriggerAfterIterations("p", delays[at]);
        for (int call = 0; call < 5; call++)
            CHECK_INT(probe(0), 0);
    }
}

static void row_8_a_trigger_needs_a_fault(void) {
    start();
    faultcheck_setTriggerAfterIterations("p", 1);
    CHECK_ERROR(FC_E_NO_FAULT, "\"p\"");
    probe(0);
    faultcheck_setTriggerOnceAfterIterations("p", 1);
    CHECK_ERROR(FC_E_NO_FAULT, "\"p\"");
    faultcheck_setDurationAfterTrigger("p", 1);
    CHECK_ERROR(FC_E_NO_FAULT, "\"p\"");
    faultcheck_packet_setTriggerAfterIterations("p", 1);
    CHECK_ERROR(FC_E_NO_FAULT, "\"p\"");
    faultcheck_packet_setTriggerOnceAfterIterations("p", 1);
    CHECK_ERROR(FC_E_NO_FAULT, "\"p\"");
    faultcheck_packet_setDurationAfterTrigger("p", 1);
    CHECK_ERROR(FC_E_NO_FAULT, "\"p\"");
}

static void a_refused_fault_shields_the_older_one(void) {
    start();
    faultcheck_addFaultOffset("p", 1);
    faultcheck_addFaultBitFlip("p", 99);
    CHECK_ERROR(FC_E_BIT, "99");
    faultcheck_setTriggerAfterIterations("p", 100);
    CHECK_ERROR(FC_E_NO_FAULT, "refused");
    CHECK_INT(fc_latest(NULL, "p"), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "refused");
    CHECK_INT(probe(0), 1);
    faultcheck_addFaultOffset("p", 10);
    faultcheck_setTriggerAfterIterations("p", 100);
    CHECK_NO_ERROR();
    CHECK_INT(probe(0), 1);
}

static void row_10_disabled_faults_inject_nothing(void) {
    start();
    fc_fault_id fault = fc_add_offset(NULL, "p", 1);
    fc_trigger_once_after(NULL, fault, 1);
    CHECK_INT(fc_enable(NULL, fault, false), FC_OK);
    for (int call = 0; call < 5; call++)
        CHECK_INT(probe(0), 0);
    CHECK_INT(fc_enable(NULL, fault, true), FC_OK);
    CHECK_INT(probe(0), 0); /* the trigger stood still */
    CHECK_INT(probe(0), 1);
    CHECK_INT(probe(0), 0);
    CHECK_INT(fc_enable(NULL, 12345, true), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "12345");
}

static void row_11_corruption_past_the_end_is_skipped(void) {
    char data[8] = "xxxxxxx";
    int len;
    start();
    faultcheck_packet_addFaultCorruptionBitFlip("c", 2, 0);
    faultcheck_packet_addPacket("c", "AB", 2);
    CHECK_INT(faultcheck_packet_getPacket("c", data, &len), 1);
    CHECK_INT(len, 2);
    CHECK(memcmp(data, "ABxxxxx", 7) == 0);
    CHECK_ERROR(FC_E_INDEX,
                "channel \"c\", fault 1: corruption of byte 2 skipped, the packet has 2");
}

static void rows_12_13_15_bad_packet_faults_are_refused(void) {
    char data[8];
    start();
    faultcheck_packet_addFaultCorruptionBitFlip("c", -1, 0);
    CHECK_ERROR(FC_E_INDEX, "\"c\"");
    faultcheck_packet_addFaultCorruptionBitFlip("c", 0, 8);
    CHECK_ERROR(FC_E_BIT, "0..7");
    faultcheck_packet_addFaultCorruptionBitFlip("c", 0, -1);
    CHECK_ERROR(FC_E_BIT, "0..7");
    faultcheck_packet_addFaultDrop("c", -1);
    CHECK_ERROR(FC_E_ARG, "below 0");
    faultcheck_packet_addFaultRepeat("c", -1);
    CHECK_ERROR(FC_E_ARG, "below 0");
    faultcheck_packet_addPacket("c", "A", -1);
    CHECK_ERROR(FC_E_ARG, "below 0");
    faultcheck_packet_addPacket("c", NULL, 1);
    CHECK_ERROR(FC_E_ARG, "NULL");
    CHECK_INT(faultcheck_packet_getPacket("c", data, NULL), 0);
    CHECK_INT(faultcheck_packet_getPacket("c", NULL, NULL), 0);
    CHECK_ERROR(FC_E_ARG, "NULL");
}

static void row_14_repeat_after_drop_repeats_what_is_delivered(void) {
    char data[8];
    char got[5] = "";
    int len;
    start();
    faultcheck_packet_addFaultDrop("c", 1);
    faultcheck_packet_addFaultRepeat("c", 1);
    for (int at = 0; at < 3; at++)
        faultcheck_packet_addPacket("c", &"ABC"[at], 1);
    for (int at = 0; faultcheck_packet_getPacket("c", data, &len) == 1 && at < 4; at++)
        got[at] = data[0];
    CHECK(strcmp(got, "BBC") == 0);
}

static void row_16_a_small_buffer_changes_nothing(void) {
    char data[8] = "xxxxxxx";
    size_t len = 0;
    start();
    fc_fault_id flip = fc_channel_add_corruption(NULL, "c", 0, 0);
    fc_trigger_once_after(NULL, flip, 0);
    fc_channel_add_drop(NULL, "c", 1);
    fc_channel_put(NULL, "c", "lost", 4);
    fc_channel_put(NULL, "c", "ABCDE", 5);
    CHECK_INT(fc_channel_get(NULL, "c", "", data, 4, &len), FC_E_SPACE);
    CHECK_INT(len, 5);
    CHECK_ERROR(FC_E_SPACE, "5 bytes");
    CHECK(strcmp(data, "xxxxxxx") == 0);
    CHECK_INT(fc_channel_depth(NULL, "c", ""), 2);
    CHECK_INT(fc_channel_get(NULL, "c", "", NULL, 0, &len), FC_E_SPACE);
    CHECK_ERROR(FC_E_SPACE, "5 bytes");
    CHECK_INT(fc_channel_get(NULL, "c", "", data, 8, &len), 1);
    CHECK(memcmp(data, "ABCDE", 5) == 0); /* drop took "lost" and the corruption with it */
    fc_channel_remove_all_faults(NULL);
    fc_channel_put(NULL, "c", "ABCDE", 5);
    CHECK_INT(fc_channel_get(NULL, "c", "", data, 4, NULL), FC_E_SPACE);
    CHECK_ERROR(FC_E_SPACE, "\"c\"");
    fc_channel_clear(NULL, "c");
    CHECK_INT(fc_channel_get(NULL, "c", "", data, 8, &len), 0);
}

static void row_17_identifiers_are_exact_bytes(void) {
    start();
    fc_add_offset(NULL, "\xff", 1);
    int32_t value = 0;
    fc_probe_i32(NULL, "\xfe", &value);
    CHECK_INT(value, 0);
    fc_probe_i32(NULL, "\xff", &value);
    CHECK_INT(value, 1);
}

static void a_null_value_is_refused(void) {
    start();
    faultcheck_injectFaultInt("p", NULL);
    CHECK_ERROR(FC_E_ARG, "\"p\"");
    faultcheck_addFaultOffset("p", 1);
    CHECK_INT(fc_probe_f64(NULL, "p", NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "\"p\"");
    CHECK_INT(fc_probe_bytes(NULL, "p", NULL, 3), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "\"p\"");
    CHECK_INT(fc_error_count(NULL), 3);
}

int main(void) {
    row_1_stuck_holds_per_type_and_window();
    row_2_ints_saturate();
    row_3_bit_indexes_are_checked();
    row_4_each_bit_of_a_double_flips_alone();
    row_5_random_flips_reach_every_bit();
    row_7_delays_are_64_bits_wide();
    row_8_a_trigger_needs_a_fault();
    a_refused_fault_shields_the_older_one();
    row_10_disabled_faults_inject_nothing();
    row_11_corruption_past_the_end_is_skipped();
    rows_12_13_15_bad_packet_faults_are_refused();
    row_14_repeat_after_drop_repeats_what_is_delivered();
    row_16_a_small_buffer_changes_nothing();
    row_17_identifiers_are_exact_bytes();
    a_null_value_is_refused();
    return CHECK_RESULT();
}
