/* original_program.c: a program as it was written for the original fault injector, in C and in C++.
 *
 * It includes the original header names and uses nothing else; test/examples_test.sh compiles it
 * unchanged as C99 and as C++17 against an installed FaultCheck. The expected values are worked out
 * by hand from the description of the original. Every function of the two headers is called. Exits
 * with the number of differences. */
#include "faultcheck_packet_wrapper.h"
#include "faultcheck_types.h"
#include "faultcheck_wrapper.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int differences;

static void expect_double(const char *what, double expected, double got) {
    if (!(expected == got)) {
        printf("%s: expected %.17g, got %.17g\n", what, expected, got);
        differences++;
    }
}

static void expect(const char *what, long expected, long got) {
    expect_double(what, (double)expected, (double)got);
}

static int int_probe(const char *id, int value) {
    faultcheck_injectFaultInt(id, &value);
    return value;
}

static double double_probe(const char *id, double value) {
    faultcheck_injectFaultDouble(id, &value);
    return value;
}

/* ---- faults of probes ---- */

static void int_faults_truncate_toward_zero(void) {
    faultcheck_addFaultOffset("offset", 0.5);
    expect("-1 + 0.5", 0, int_probe("offset", -1));
    faultcheck_addFaultAmplification("gain", -1.5);
    expect("3 * -1.5", -4, int_probe("gain", 3));
    faultcheck_addFaultSetTo("fixed", -1.9);
    expect("set to -1.9", -1, int_probe("fixed", 12345));
    faultcheck_addFaultBitFlip("sign", 31);
    expect("sign bit of 0", -2147483647L - 1, int_probe("sign", 0));
}

static void double_faults_follow_ieee_754(void) {
    faultcheck_addFaultOffset("d offset", 0.5);
    expect_double("-1.0 + 0.5", -0.5, double_probe("d offset", -1));
    faultcheck_addFaultAmplification("d gain", -1.5);
    expect_double("3.0 * -1.5", -4.5, double_probe("d gain", 3));
    expect_double("infinity * -1.5", -HUGE_VAL, double_probe("d gain", HUGE_VAL));
    faultcheck_addFaultSetTo("d fixed", -1.9);
    expect_double("set to -1.9, double", -1.9, double_probe("d fixed", 7));
    /* Bit 0 of the IEEE-754 word of 1.0 is worth 2^-52. */
    faultcheck_addFaultBitFlip("d bit", 0);
    expect_double("bit 0 of 1.0", 1.0 + ldexp(1, -52), double_probe("d bit", 1.0));
}

static void faults_apply_in_the_order_of_adding(void) {
    faultcheck_addFaultBitFlip("chain", 2);
    faultcheck_addFaultOffset("chain", 23);
    faultcheck_addFaultBitFlip("chain", 11);
    expect("no fault has been triggered yet", 0, faultcheck_numActiveFaults("chain"));
    expect("((0 ^ 4) + 23) ^ 2048", 2075, int_probe("chain", 0));
    expect("three are active", 3, faultcheck_numActiveFaults("chain"));
    faultcheck_removeAllFaultsIdentifier("chain");
    expect("removed", 0, int_probe("chain", 0));
    expect("none is active", 0, faultcheck_numActiveFaults("chain"));
    expect("the others stay", 0, int_probe("offset", -1));
}

static void a_random_flip_changes_one_bit(void) {
    faultcheck_addFaultBitFlipRandom("random");
    for (int call = 0; call < 100; call++) {
        unsigned flipped = (unsigned)int_probe("random", 0);
        expect("a power of two", 1, flipped != 0 && (flipped & (flipped - 1)) == 0);
    }
}

/* ---- triggers ---- */

static void triggers_open_windows_of_calls(void) {
    faultcheck_addFaultBitFlip("windows", 2);
    faultcheck_setTriggerAfterIterations("windows", 120);
    faultcheck_setDurationAfterTrigger("windows", 45);
    faultcheck_addFaultOffset("windows", 23);
    faultcheck_setTriggerAfterIterations("windows", 45);
    faultcheck_setDurationAfterTrigger("windows", 200);
    faultcheck_addFaultBitFlip("windows", 11);
    faultcheck_setTriggerAfterIterations("windows", 130);
    faultcheck_setDurationAfterTrigger("windows", 10);
    for (int call = 1; call <= 300; call++) {
        int value = call >= 121 && call <= 165 ? 4 : 0;
        value += call >= 46 && call <= 245 ? 23 : 0;
        value ^= call >= 131 && call <= 140 ? 2048 : 0;
        expect("windows", value, int_probe("windows", 0));
    }
}

static void a_once_trigger_affects_one_call(void) {
    faultcheck_addFaultOffset("once", 1);
    faultcheck_setTriggerOnceAfterIterations("once", 2);
    static const int expected[] = {0, 0, 1, 0, 0};
    for (int call = 0; call < 5; call++) {
        expect("once", expected[call], int_probe("once", 0));
    }
    faultcheck_setDurationAfterTrigger("once", 1); /* revives it: the countdown is at its end */
    expect("once more", 1, int_probe("once", 0));
    faultcheck_setDurationAfterTrigger("once", -1);
    expect("for ever", 1, int_probe("once", 0));
    faultcheck_setTriggerAfterIterations("once", 0);
    expect("at once", 1, int_probe("once", 0));
}

/* ---- packets ---- */

static void put(char first) {
    char packet[2];
    packet[0] = first;
    packet[1] = '.';
    faultcheck_packet_addPacket("bus", packet, 2);
}

/* The next packets until three gets in succession delivered nothing, first bytes only. */
static const char *drained(void) {
    static char firsts[32];
    size_t got = 0;
    for (int empty = 0; empty < 3 && got < sizeof firsts - 1;) {
        char packet[8];
        int length = -1;
        if (faultcheck_packet_getPacket("bus", packet, &length)) {
            expect("the length is told", 2, length);
            firsts[got++] = packet[0];
            empty = 0;
        } else {
            expect("an empty channel writes no length", -1, length);
            empty++;
        }
    }
    firsts[got] = '\0';
    return firsts;
}

static void expect_packets(const char *expected) {
    put('A');
    put('B');
    put('C');
    const char *got = drained();
    if (strcmp(expected, got) != 0) {
        printf("packets: expected %s, got %s\n", expected, got);
        differences++;
    }
    faultcheck_packet_removeAllFaultsIdentifier("bus");
}

static void packets_are_altered_dropped_and_repeated(void) {
    expect_packets("ABC");
    faultcheck_packet_addFaultCorruptionBitFlip("bus", 0, 5); /* makes lower case */
    expect_packets("abc");
    faultcheck_packet_addFaultCorruptionBitFlip("bus", 0, 5);
    faultcheck_packet_setTriggerOnceAfterIterations("bus", 1);
    expect_packets("AbC");
    faultcheck_packet_addFaultCorruptionBitFlip("bus", 0, 5);
    faultcheck_packet_setTriggerAfterIterations("bus", 1);
    expect_packets("Abc");
    faultcheck_packet_addFaultCorruptionBitFlip("bus", 0, 5);
    faultcheck_packet_setDurationAfterTrigger("bus", 2);
    expect_packets("abC");
    faultcheck_packet_addFaultDrop("bus", 2);
    expect_packets("C");
    faultcheck_packet_addFaultRepeat("bus", 2);
    expect_packets("AAABC");
    faultcheck_packet_addFaultRepeat("bus", 1);
    faultcheck_packet_addFaultDrop("bus", 1);
    expect_packets("ABC");
}

static void an_empty_packet_is_delivered(void) {
    char nothing = 'x';
    int length = -1;
    faultcheck_packet_addPacket("empty", &nothing, 0);
    expect("delivered", 1, faultcheck_packet_getPacket("empty", &nothing, &length));
    expect("of length 0", 0, length);
    expect("the buffer is untouched", 'x', nothing);
    expect("once", 0, faultcheck_packet_getPacket("empty", &nothing, NULL));
    faultcheck_packet_removeAllFaults();
}

static void the_types_have_their_values(void) {
    FAULT_TYPE last_fault = FAULT_SET_TO;
    TRIGGER_TYPE last_trigger = TRG_RANDOM_ONCE;
    PACKET_FAULT_TYPE last_packet_fault = PACKET_FAULT_CURRUPTION;
    expect("FAULT_SET_TO", 6, last_fault);
    expect("TRG_RANDOM_ONCE", 3, last_trigger);
    expect("PACKET_FAULT_CURRUPTION", 3, last_packet_fault);
}

int main(void) {
    the_types_have_their_values();
    int_faults_truncate_toward_zero();
    double_faults_follow_ieee_754();
    faults_apply_in_the_order_of_adding();
    a_random_flip_changes_one_bit();
    triggers_open_windows_of_calls();
    a_once_trigger_affects_one_call();
    packets_are_altered_dropped_and_repeated();
    an_empty_packet_is_delivered();
    void *instance = faultcheck_instance();
    expect("an instance that stays", 1, instance != NULL && instance == faultcheck_instance());
    faultcheck_removeAllFaults();
    expect("all removed", 5, int_probe("once", 5));
    printf("%d differences\n", differences);
    return differences;
}
