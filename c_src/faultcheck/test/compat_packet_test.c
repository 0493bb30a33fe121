/* The compatible packet channels (section 4 of the reference). */
#include "check.h"
#include "faultcheck_packet_wrapper.h"
#include "fc.h"

static const char *id = "c";

static void start(const char *packets) {
    fc_reset(NULL);
    for (; *packets != '\0'; packets++)
        faultcheck_packet_addPacket(id, packets, 1);
}

/* The packets delivered by `gets` gets, '-' for a get that delivered nothing. */
static const char *take(int gets) {
    static char got[64];
    int at = 0;
    for (; gets > 0; gets--) {
        char data[8];
        int len = -1;
        if (faultcheck_packet_getPacket(id, data, &len) == 1) {
            CHECK_INT(len, 1);
            got[at++] = data[0];
        } else {
            CHECK_INT(len, -1);
            got[at++] = '-';
        }
    }
    got[at] = '\0';
    return got;
}

#define CHECK_TAKE(gets, expected)                                                                 \
    do {                                                                                           \
        const char *check_took = take(gets);                                                       \
        if (strcmp(check_took, expected) != 0) {                                                   \
            check_failures++;                                                                      \
            fprintf(stderr, "%s:%d: got %s, expected %s\n", __FILE__, __LINE__, check_took,        \
                    expected);                                                                     \
        }                                                                                          \
    } while (0)

static void packets_come_in_order(void) {
    start("ABC");
    CHECK_TAKE(5, "ABC--");
}

static void a_packet_of_length_0_is_delivered(void) {
    char data = 'x';
    int len = 7;
    start("");
    faultcheck_packet_addPacket(id, NULL, 0);
    CHECK_INT(faultcheck_packet_getPacket(id, &data, &len), 1);
    CHECK_INT(len, 0);
    CHECK_INT(data, 'x');
    faultcheck_packet_addPacket(id, "A", 1);
    CHECK_INT(faultcheck_packet_getPacket(id, &data, NULL), 1);
    CHECK_INT(data, 'A');
}

static void corruptions_accumulate(void) {
    start("AA");
    faultcheck_packet_addFaultCorruptionBitFlip(id, 0, 0);
    faultcheck_packet_addFaultCorruptionBitFlip(id, 0, 1);
    CHECK_TAKE(2, "BB");
}

static void drop_is_a_budget_for_life(void) {
    start("1");
    faultcheck_packet_addFaultDrop(id, 3);
    CHECK_TAKE(1, "-");
    for (const char *at = "2345"; *at != '\0'; at++)
        faultcheck_packet_addPacket(id, at, 1);
    CHECK_TAKE(3, "45-");
}

static void an_expired_trigger_leaves_the_budget_unused(void) {
    start("1");
    faultcheck_packet_addFaultDrop(id, 3);
    faultcheck_packet_setTriggerOnceAfterIterations(id, 0);
    CHECK_TAKE(1, "-");
    faultcheck_packet_addPacket(id, "2", 1);
    CHECK_TAKE(1, "2");
}

static void repeat_delivers_n_plus_1_times(void) {
    start("AB");
    faultcheck_packet_addFaultRepeat(id, 2);
    CHECK_TAKE(5, "AAAB-");
}

static void an_empty_get_counts_and_keeps_the_repeat_budget(void) {
    start("");
    faultcheck_packet_addFaultRepeat(id, 1);
    CHECK_TAKE(1, "-");
    faultcheck_packet_addPacket(id, "A", 1);
    CHECK_TAKE(3, "AA-");

    start("");
    faultcheck_packet_addFaultRepeat(id, 1);
    faultcheck_packet_setTriggerOnceAfterIterations(id, 0);
    CHECK_TAKE(1, "-"); /* uses the trigger up */
    faultcheck_packet_addPacket(id, "A", 1);
    CHECK_TAKE(2, "A-");
}

static void faults_apply_to_copies_afresh(void) {
    start("A");
    faultcheck_packet_addFaultRepeat(id, 2);
    faultcheck_packet_addFaultCorruptionBitFlip(id, 0, 1);
    CHECK_TAKE(4, "CCC-");

    start("A");
    faultcheck_packet_addFaultCorruptionBitFlip(id, 0, 1);
    faultcheck_packet_setTriggerOnceAfterIterations(id, 0);
    faultcheck_packet_addFaultRepeat(id, 2);
    CHECK_TAKE(4, "CAA-");
}

static void order_matters(void) {
    start("A@");
    faultcheck_packet_addFaultCorruptionBitFlip(id, 0, 1);
    faultcheck_packet_setTriggerOnceAfterIterations(id, 0);
    faultcheck_packet_addFaultDrop(id, 1);
    CHECK_TAKE(2, "@-"); /* the corruption went with the packet dropped */

    start("A@");
    faultcheck_packet_addFaultDrop(id, 1);
    faultcheck_packet_addFaultCorruptionBitFlip(id, 0, 1);
    faultcheck_packet_setTriggerOnceAfterIterations(id, 0);
    CHECK_TAKE(2, "B-");

    start("AB");
    faultcheck_packet_addFaultRepeat(id, 1);
    faultcheck_packet_addFaultDrop(id, 1);
    CHECK_TAKE(3, "AB-");
}

static void a_budget_of_0_does_nothing(void) {
    start("AB");
    faultcheck_packet_addFaultRepeat(id, 0);
    faultcheck_packet_addFaultDrop(id, 0);
    CHECK_TAKE(3, "AB-");
}

static void huge_budgets_cost_nothing(void) {
    start("AB");
    faultcheck_packet_addFaultRepeat(id, 2147483647);
    CHECK_TAKE(3, "AAA");
    CHECK_INT(fc_channel_depth(NULL, id, ""), 2147483647LL - 2 + 1);
    faultcheck_packet_removeAllFaultsIdentifier(id);
    faultcheck_packet_addFaultDrop(id, 2147483647);
    CHECK_TAKE(2, "--");
    CHECK_INT(fc_channel_depth(NULL, id, ""), 0);
}

static void removal_keeps_packets_and_copies(void) {
    start("AB");
    faultcheck_packet_addFaultRepeat(id, 1);
    CHECK_TAKE(1, "A");
    faultcheck_packet_removeAllFaults();
    CHECK_TAKE(3, "AB-");
}

static void the_first_get_of_a_fault_counts_from_its_trigger(void) {
    start("ABCD");
    faultcheck_packet_addFaultDrop(id, 1);
    faultcheck_packet_setTriggerAfterIterations(id, 2);
    CHECK_TAKE(4, "ABD-");
}

static void a_long_packet_comes_back_whole(void) {
    char sent[3000], got[3000];
    int len;
    start("");
    for (int at = 0; at < 3000; at++)
        sent[at] = (char)(at * 7);
    for (int size = 0; size < 3000; size += 37)
        faultcheck_packet_addPacket(id, sent, size);
    faultcheck_packet_addFaultCorruptionBitFlip(id, 0, 0);
    faultcheck_packet_setTriggerOnceAfterIterations(id, 1);
    for (int size = 0; size < 3000; size += 37) {
        CHECK_INT(faultcheck_packet_getPacket(id, got, &len), 1);
        CHECK_INT(len, size);
        got[0] = (char)(got[0] ^ (size == 37));
        CHECK(memcmp(sent, got, (size_t)size) == 0);
    }
}

int main(void) {
    packets_come_in_order();
    a_packet_of_length_0_is_delivered();
    corruptions_accumulate();
    drop_is_a_budget_for_life();
    an_expired_trigger_leaves_the_budget_unused();
    repeat_delivers_n_plus_1_times();
    an_empty_get_counts_and_keeps_the_repeat_budget();
    faults_apply_to_copies_afresh();
    order_matters();
    a_budget_of_0_does_nothing();
    huge_budgets_cost_nothing();
    removal_keeps_packets_and_copies();
    the_first_get_of_a_fault_counts_from_its_trigger();
    a_long_packet_comes_back_whole();
    return CHECK_RESULT();
}
