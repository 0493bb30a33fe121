/* Profile 1 step by step; the recorded sequences of test/data/e2e_vectors.json.gz check the rest.
 */
#include "E2E_P01.h"
#include "check.h"
#include <string.h>

static const E2E_P01ConfigType variant_1c = {.CounterOffset = 8,
                                             .CRCOffset = 0,
                                             .DataID = 0x0123,
                                             .DataIDNibbleOffset = 12,
                                             .DataIDMode = E2E_P01_DATAID_NIBBLE,
                                             .DataLength = 64,
                                             .MaxDeltaCounterInit = 2,
                                             .MaxNoNewOrRepeatedData = 3,
                                             .SyncCounterInit = 1};

static void null_arguments_are_refused(void) {
    E2E_P01ProtectStateType sender;
    E2E_P01CheckStateType receiver;
    uint8 data[8] = {0};
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P01ProtectInit(NULL));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P01CheckInit(NULL));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P01CheckConfig(NULL));
    CHECK_EQ(E2E_E_OK, E2E_P01ProtectInit(&sender));
    CHECK_EQ(E2E_E_OK, E2E_P01CheckInit(&receiver));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P01Protect(NULL, &sender, data));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P01Protect(&variant_1c, NULL, data));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P01Protect(&variant_1c, &sender, NULL));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P01Check(NULL, &receiver, data));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P01Check(&variant_1c, NULL, data));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P01Check(&variant_1c, &receiver, NULL));
    CHECK_EQ(0, receiver.MaxDeltaCounter);
    CHECK_EQ(0, sender.Counter);
}

/* The worked examples of the protocol specification, given for profile 11, which has the same
 * packet. */
static void published_packets(void) {
    static const uint8 both[2][8] = {{0xcc, 0x00}, {0x91, 0x01}};
    static const uint8 nibble[2][8] = {{0x2a, 0x10}, {0x77, 0x11}};
    E2E_P01ConfigType config = variant_1c;
    E2E_P01ProtectStateType sender = {0};
    uint8 data[8] = {0};
    for (int i = 0; i < 2; i++) {
        CHECK_EQ(E2E_E_OK, E2E_P01Protect(&config, &sender, data));
        CHECK(memcmp(nibble[i], data, 8) == 0);
    }
    config.DataIDMode = E2E_P01_DATAID_BOTH;
    sender.Counter = 0;
    memset(data, 0, sizeof data);
    for (int i = 0; i < 2; i++) {
        CHECK_EQ(E2E_E_OK, E2E_P01Protect(&config, &sender, data));
        CHECK(memcmp(both[i], data, 8) == 0);
    }
}

static void the_counter_wraps_after_14(void) {
    E2E_P01ProtectStateType sender = {14};
    uint8 data[8] = {0};
    E2E_P01Protect(&variant_1c, &sender, data);
    CHECK_EQ(0x1E, data[1]);
    CHECK_EQ(0, sender.Counter);
}

static void the_other_nibble_is_left_alone(void) {
    E2E_P01ConfigType config = variant_1c;
    E2E_P01ProtectStateType sender = {5};
    uint8 data[8] = {0, 0xFF};
    config.DataIDMode = E2E_P01_DATAID_ALT;
    E2E_P01Protect(&config, &sender, data);
    CHECK_EQ(0xF5, data[1]);
    config.CounterOffset = 12;
    E2E_P01Protect(&config, &sender, data);
    CHECK_EQ(0x65, data[1]);
}

static E2E_P01CheckStatusType receive(E2E_P01CheckStateType *receiver, uint8 counter) {
    E2E_P01ProtectStateType sender = {counter};
    uint8 data[8] = {0};
    E2E_P01Protect(&variant_1c, &sender, data);
    receiver->NewDataAvailable = TRUE;
    CHECK_EQ(E2E_E_OK, E2E_P01Check(&variant_1c, receiver, data));
    return receiver->Status;
}

static E2E_P01CheckStatusType receive_nothing(E2E_P01CheckStateType *receiver) {
    const uint8 data[8] = {0};
    receiver->NewDataAvailable = FALSE;
    CHECK_EQ(E2E_E_OK, E2E_P01Check(&variant_1c, receiver, data));
    return receiver->Status;
}

static void a_receiver_goes_through_every_status(void) {
    E2E_P01CheckStateType receiver;
    E2E_P01CheckInit(&receiver);
    CHECK_EQ(E2E_P01STATUS_NONEWDATA, receive_nothing(&receiver));
    CHECK_EQ(E2E_P01STATUS_INITIAL, receive(&receiver, 13));
    CHECK_EQ(E2E_P01STATUS_OK, receive(&receiver, 14));
    CHECK_EQ(E2E_P01STATUS_REPEATED, receive(&receiver, 14));
    CHECK_EQ(E2E_P01STATUS_OKSOMELOST, receive(&receiver, 1));
    CHECK_EQ(1, receiver.LostData);
    CHECK_EQ(E2E_P01STATUS_WRONGSEQUENCE, receive(&receiver, 8));
    CHECK_EQ(E2E_P01STATUS_SYNC, receive(&receiver, 9));
    CHECK_EQ(E2E_P01STATUS_OK, receive(&receiver, 10));
    for (int i = 0; i < 4; i++) {
        CHECK_EQ(E2E_P01STATUS_NONEWDATA, receive_nothing(&receiver));
    }
    CHECK_EQ(E2E_P01STATUS_SYNC, receive(&receiver, 11));
    CHECK_EQ(E2E_P01STATUS_SYNC, receive(&receiver, 12));
    CHECK_EQ(E2E_P01STATUS_OK, receive(&receiver, 13));
}

static void a_wrong_crc_or_id_nibble_changes_nothing_else(void) {
    E2E_P01ProtectStateType sender = {0};
    E2E_P01CheckStateType receiver, before;
    uint8 data[8] = {0};
    E2E_P01CheckInit(&receiver);
    E2E_P01Protect(&variant_1c, &sender, data);
    before = receiver;
    before.MaxDeltaCounter++;
    before.Status = E2E_P01STATUS_WRONGCRC;
    data[5] ^= 0x10;
    CHECK_EQ(E2E_E_OK, E2E_P01Check(&variant_1c, &receiver, data));
    CHECK(memcmp(&before, &receiver, sizeof before) == 0);
    data[5] ^= 0x10;
    /* Another sender's nibble under a right CRC: only the comparison with the Data ID can tell. */
    E2E_P01ConfigType other = variant_1c;
    other.DataID = 0x0223;
    sender.Counter = 0;
    E2E_P01Protect(&other, &sender, data);
    before.MaxDeltaCounter++;
    CHECK_EQ(E2E_E_OK, E2E_P01Check(&variant_1c, &receiver, data));
    CHECK(memcmp(&before, &receiver, sizeof before) == 0);
}

static void counter_15_is_refused_and_status_is_stale(void) {
    E2E_P01CheckStateType receiver;
    uint8 data[8] = {0, 0x1F};
    E2E_P01CheckInit(&receiver);
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P01Check(&variant_1c, &receiver, data));
    CHECK_EQ(E2E_P01STATUS_NONEWDATA, receiver.Status);
    CHECK_EQ(1, receiver.MaxDeltaCounter);
    CHECK_EQ(TRUE, receiver.WaitForFirstData);
}

#define CHANGED(member, value)                                                                     \
    do {                                                                                           \
        E2E_P01ConfigType changed = variant_1c;                                                    \
        changed.member = (value);                                                                  \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P01CheckConfig(&changed));                              \
    } while (0)

static void configurations_out_of_range_are_named_wrong(void) {
    CHECK_EQ(E2E_E_OK, E2E_P01CheckConfig(&variant_1c));
    CHANGED(DataLength, 8);
    CHANGED(DataLength, 248);
    CHANGED(DataLength, 63);
    CHANGED(CRCOffset, 4);
    CHANGED(CRCOffset, 64);
    CHANGED(CRCOffset, 8);
    CHANGED(CounterOffset, 10);
    CHANGED(CounterOffset, 64);
    CHANGED(CounterOffset, 12);
    CHANGED(CounterOffset, 4);
    CHANGED(DataIDNibbleOffset, 13);
    CHANGED(DataIDNibbleOffset, 64);
    CHANGED(DataIDNibbleOffset, 4);
    CHANGED(DataID, 0x1000);
    CHANGED(DataIDMode, E2E_P01_DATAID_LOW);
    CHANGED(MaxDeltaCounterInit, 15);
    CHANGED(MaxNoNewOrRepeatedData, 15);
    CHANGED(SyncCounterInit, 15);
}

int main(void) {
    null_arguments_are_refused();
    published_packets();
    the_counter_wraps_after_14();
    the_other_nibble_is_left_alone();
    a_receiver_goes_through_every_status();
    a_wrong_crc_or_id_nibble_changes_nothing_else();
    counter_15_is_refused_and_status_is_stale();
    configurations_out_of_range_are_named_wrong();
    return check_result();
}
