/* Profile 2 step by step; what it shares with profile 1 is tried there too, the bytes by the
 * recorded vectors. */
#include "E2E_P02.h"
#include "check.h"
#include <string.h>

static const E2E_P02ConfigType config = {
    .DataLength = 64,
    .DataIDList = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16},
    .MaxDeltaCounterInit = 2,
    .MaxNoNewOrRepeatedData = 3,
    .SyncCounterInit = 1};

static void null_arguments_are_refused(void) {
    E2E_P02ProtectStateType sender = {0};
    E2E_P02CheckStateType receiver = {0};
    uint8 data[8] = {0};
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P02CheckConfig(NULL));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P02ProtectInit(NULL));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P02CheckInit(NULL));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P02Protect(NULL, &sender, data));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P02Protect(&config, NULL, data));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P02Protect(&config, &sender, NULL));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P02Check(NULL, &receiver, data));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P02Check(&config, NULL, data));
    CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_P02Check(&config, &receiver, NULL));
    CHECK_EQ(0, sender.Counter);
    CHECK_EQ(0, receiver.MaxDeltaCounter);
}

static E2E_P02CheckStatusType receive(E2E_P02CheckStateType *receiver, uint8 counter) {
    E2E_P02ProtectStateType sender = {(uint8)((counter + 15) % 16)};
    uint8 data[8] = {0};
    CHECK_EQ(E2E_E_OK, E2E_P02Protect(&config, &sender, data));
    CHECK_EQ(counter, sender.Counter);
    CHECK_EQ(counter, data[1]);
    receiver->NewDataAvailable = TRUE;
    CHECK_EQ(E2E_E_OK, E2E_P02Check(&config, receiver, data));
    return receiver->Status;
}

static void a_receiver_goes_through_every_status(void) {
    E2E_P02CheckStateType receiver;
    uint8 data[8] = {0};
    CHECK_EQ(E2E_E_OK, E2E_P02CheckInit(&receiver));
    CHECK_EQ(E2E_P02STATUS_NONEWDATA, receiver.Status);
    CHECK_EQ(E2E_P02STATUS_INITIAL, receive(&receiver, 14));
    CHECK_EQ(E2E_P02STATUS_OK, receive(&receiver, 15));
    CHECK_EQ(E2E_P02STATUS_OKSOMELOST, receive(&receiver, 1));
    CHECK_EQ(1, receiver.LostData);
    CHECK_EQ(E2E_P02STATUS_REPEATED, receive(&receiver, 1));
    CHECK_EQ(E2E_E_OK, E2E_P02Check(&config, &receiver, data));
    CHECK_EQ(E2E_P02STATUS_WRONGCRC, receiver.Status);
    CHECK_EQ(E2E_P02STATUS_WRONGSEQUENCE, receive(&receiver, 9));
    CHECK_EQ(E2E_P02STATUS_SYNC, receive(&receiver, 10));
    CHECK_EQ(E2E_P02STATUS_OK, receive(&receiver, 11));
    receiver.NewDataAvailable = FALSE;
    CHECK_EQ(E2E_E_OK, E2E_P02Check(&config, &receiver, data));
    CHECK_EQ(E2E_P02STATUS_NONEWDATA, receiver.Status);
}

static void the_counter_byte_keeps_its_high_nibble(void) {
    E2E_P02ProtectStateType sender = {0};
    uint8 data[8] = {0, 0xF0};
    CHECK_EQ(E2E_E_OK, E2E_P02Protect(&config, &sender, data));
    CHECK_EQ(0xF1, data[1]);
}

/* With an offset the CRC covers what profile 22 covers: all bytes but its own. */
static void with_an_offset_every_flip_is_seen(void) {
    E2E_P02ConfigType offset = config;
    E2E_P02ProtectStateType sender = {4};
    uint8 data[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    offset.Offset = 24;
    CHECK_EQ(E2E_E_OK, E2E_P02Protect(&offset, &sender, data));
    CHECK_EQ(5, data[4] & 0x0F);
    for (int bit = 0; bit < 64; bit++) {
        E2E_P02CheckStateType receiver = {.LastValidCounter = 4, .NewDataAvailable = TRUE};
        data[bit / 8] ^= (uint8)(1U << bit % 8);
        CHECK_EQ(E2E_E_OK, E2E_P02Check(&offset, &receiver, data));
        CHECK_EQ(E2E_P02STATUS_WRONGCRC, receiver.Status);
        data[bit / 8] ^= (uint8)(1U << bit % 8);
    }
}

static void a_header_outside_the_data_is_refused(void) {
    E2E_P02ConfigType wrong = config;
    E2E_P02ProtectStateType sender = {0};
    E2E_P02CheckStateType receiver = {.NewDataAvailable = TRUE};
    uint8 data[8] = {0};
    wrong.Offset = 56;
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P02Protect(&wrong, &sender, data));
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P02Check(&wrong, &receiver, data));
    wrong.Offset = 0;
    wrong.DataLength = 8;
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P02Protect(&wrong, &sender, data));
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P02Check(&wrong, &receiver, data));
    CHECK_EQ(0, sender.Counter);
    CHECK_EQ(0, receiver.MaxDeltaCounter);
}

#define WRONG(member, value)                                                                       \
    do {                                                                                           \
        E2E_P02ConfigType changed = config;                                                        \
        changed.member = (value);                                                                  \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P02CheckConfig(&changed));                              \
    } while (0)

static void configurations_out_of_range_are_named_wrong(void) {
    CHECK_EQ(E2E_E_OK, E2E_P02CheckConfig(&config));
    WRONG(DataLength, 8);
    WRONG(DataLength, 60);
    WRONG(DataLength, 2056);
    WRONG(Offset, 4);
    WRONG(Offset, 56);
    WRONG(MaxDeltaCounterInit, 16);
    WRONG(MaxNoNewOrRepeatedData, 16);
    WRONG(SyncCounterInit, 16);
}

int main(void) {
    null_arguments_are_refused();
    a_receiver_goes_through_every_status();
    the_counter_byte_keeps_its_high_nibble();
    with_an_offset_every_flip_is_seen();
    a_header_outside_the_data_is_refused();
    configurations_out_of_range_are_named_wrong();
    return check_result();
}
