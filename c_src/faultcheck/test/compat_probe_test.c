/* The compatible probes: faults in the order of adding, conversion, triggers (sections 2 and 3 of
 * the reference). */
#include "check.h"
#include "faultcheck_wrapper.h"

#include <math.h>

static int probe(const char *id, int value) {
    faultcheck_injectFaultInt(id, &value);
    return value;
}

static double probe_double(const char *id, double value) {
    faultcheck_injectFaultDouble(id, &value);
    return value;
}

static void faults_are_applied_in_the_order_of_adding(void) {
    faultcheck_removeAllFaults();
    faultcheck_addFaultBitFlip("a", 2);
    faultcheck_addFaultOffset("a", 23);
    faultcheck_addFaultBitFlip("a", 11);
    CHECK_INT(probe("a", 0), 2075);
    CHECK_INT(faultcheck_numActiveFaults("a"), 3);
    CHECK_INT(probe("b", 7), 7);
    CHECK_INT(faultcheck_numActiveFaults("b"), 0);
    CHECK_INT(faultcheck_numActiveFaults("never probed"), 0);
}

static void results_are_truncated_toward_zero(void) {
    faultcheck_removeAllFaults();
    faultcheck_addFaultOffset("o", 0.5);
    CHECK_INT(probe("o", -1), 0);
    faultcheck_addFaultAmplification("k", -1.5);
    CHECK_INT(probe("k", 3), -4);
    faultcheck_addFaultSetTo("s", -1.9);
    CHECK_INT(probe("s", 77), -1);
}

static void doubles_follow_ieee_754(void) {
    faultcheck_removeAllFaults();
    faultcheck_addFaultAmplification("k", 2.5);
    CHECK_BITS(probe_double("k", -0.0), -0.0);
    CHECK_BITS(probe_double("k", INFINITY), INFINITY);
    CHECK(isnan(probe_double("k", NAN)));
    faultcheck_addFaultBitFlip("sign", 63);
    CHECK_BITS(probe_double("sign", 1.5), -1.5);
    faultcheck_addFaultBitFlip("low", 0);
    CHECK_BITS(probe_double("low", 1.0), 0x1.0000000000001p+0);
    faultcheck_addFaultBitFlip("31", 31);
    CHECK_INT(probe("31", 0), -2147483647 - 1);
}

/* Which of calls 1..last differ from the value put in: first and number of affected calls. */
static void affected(const char *id, int last, int *first, int *number) {
    *first = *number = 0;
    for (int call = 1; call <= last; call++)
        if (probe(id, 0) != 0) {
            *first = *first == 0 ? call : *first;
            ++*number;
        }
}

static void the_window_of_the_reference(void) {
    const struct {
        const char *id;
        unsigned long delay;
        int duration, first, number;
    } windows[] = {
        {"w1", 120, 45, 121, 45}, {"w2", 45, 200, 46, 200}, {"w3", 130, 10, 131, 10},
        {"w4", 0, 3, 1, 3},       {"w5", 4, 0, 0, 0},       {"w6", 290, -1, 291, 10},
    };
    faultcheck_removeAllFaults();
    for (size_t at = 0; at < sizeof windows / sizeof windows[0]; at++) {
        int first, number;
        faultcheck_addFaultSetTo(windows[at].id, 5);
        faultcheck_setTriggerAfterIterations(windows[at].id, windows[at].delay);
        faultcheck_setDurationAfterTrigger(windows[at].id, windows[at].duration);
        affected(windows[at].id, 300, &first, &number);
        CHECK_INT(first, windows[at].first);
        CHECK_INT(number, windows[at].number);
    }
}

static void a_once_trigger_hits_exactly_one_call(void) {
    int first, number;
    faultcheck_removeAllFaults();
    faultcheck_addFaultSetTo("a", 5);
    probe("a", 0); /* the countdown starts when the trigger is set */
    faultcheck_setTriggerOnceAfterIterations("a", 3);
    affected("a", 20, &first, &number);
    CHECK_INT(first, 4);
    CHECK_INT(number, 1);
    faultcheck_setDurationAfterTrigger("a", 2); /* revives the exhausted fault at once */
    affected("a", 20, &first, &number);
    CHECK_INT(first, 1);
    CHECK_INT(number, 2);
}

static void a_duration_set_before_the_trigger_is_lost(void) {
    int first, number;
    faultcheck_removeAllFaults();
    faultcheck_addFaultSetTo("a", 5);
    faultcheck_setDurationAfterTrigger("a", 2);
    faultcheck_setTriggerAfterIterations("a", 1);
    affected("a", 10, &first, &number);
    CHECK_INT(first, 2);
    CHECK_INT(number, 9);
}

static void triggers_act_on_the_latest_fault_only(void) {
    faultcheck_removeAllFaults();
    faultcheck_addFaultOffset("a", 1);
    faultcheck_addFaultOffset("a", 10);
    faultcheck_setTriggerAfterIterations("a", 1);
    CHECK_INT(probe("a", 0), 1);
    CHECK_INT(faultcheck_numActiveFaults("a"), 1);
    CHECK_INT(probe("a", 0), 11);
    CHECK_INT(faultcheck_numActiveFaults("a"), 2);
}

static void active_faults_are_those_of_the_latest_call(void) {
    faultcheck_removeAllFaults();
    faultcheck_addFaultOffset("a", 1);
    CHECK_INT(faultcheck_numActiveFaults("a"), 0);
    probe("a", 0);
    faultcheck_setTriggerAfterIterations("a", 100);
    CHECK_INT(faultcheck_numActiveFaults("a"), 1);
    probe("a", 0);
    CHECK_INT(faultcheck_numActiveFaults("a"), 0);
    faultcheck_removeAllFaultsIdentifier("a");
    CHECK_INT(faultcheck_numActiveFaults("a"), 0);
    CHECK_INT(probe("a", 4), 4);
}

static void null_is_the_empty_identifier(void) {
    faultcheck_removeAllFaults();
    faultcheck_addFaultOffset(NULL, 1);
    CHECK_INT(probe("", 0), 1);
    CHECK_INT(probe(NULL, 0), 1);
}

static void identifiers_of_any_length_are_told_apart(void) {
    char id[70];
    faultcheck_removeAllFaults();
    for (int length = 0; length < 64; length++) {
        memset(id, 'n', sizeof id);
        id[length] = '\0';
        faultcheck_addFaultSetTo(id, length + 1);
    }
    for (int length = 0; length < 64; length++) {
        memset(id, 'n', sizeof id);
        id[length] = '\0';
        CHECK_INT(probe(id, 0), length + 1);
        for (int at = 0; at < length; at++) { /* one byte different: another identifier */
            id[at] = 'm';
            CHECK_INT(probe(id, 0), 0);
            id[at] = 'n';
        }
    }
}

int main(void) {
    faults_are_applied_in_the_order_of_adding();
    results_are_truncated_toward_zero();
    doubles_follow_ieee_754();
    the_window_of_the_reference();
    a_once_trigger_hits_exactly_one_call();
    a_duration_set_before_the_trigger_is_lost();
    triggers_act_on_the_latest_fault_only();
    active_faults_are_those_of_the_latest_call();
    null_is_the_empty_identifier();
    identifiers_of_any_length_are_told_apart();
    return CHECK_RESULT();
}
