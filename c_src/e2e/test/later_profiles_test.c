/* The rules profiles 4, 5, 6, 7, 8, 11, 22 and 44 share, each rule tried on each of them. Bytes and
 * ID or Length mismatches are the business of the recorded vectors. */
#include "E2E_P04.h"
#include "E2E_P05.h"
#include "E2E_P06.h"
#include "E2E_P07.h"
#include "E2E_P08.h"
#include "E2E_P11.h"
#include "E2E_P22.h"
#include "E2E_P44.h"
#include "check.h"
#include <string.h>

#define BYTES 30 /* of every packet here; DataLength 240 is the most profile 11 can have */

static const E2E_P04ConfigType config_P04 = {.DataID = 0x0a0b0c0d,
                                             .Offset = 16,
                                             .MinDataLength = 120,
                                             .MaxDataLength = 248,
                                             .MaxDeltaCounter = 3};
static const E2E_P44ConfigType config_P44 = {.DataID = 0x0a0b0c0d,
                                             .Offset = 16,
                                             .MinDataLength = 120,
                                             .MaxDataLength = 248,
                                             .MaxDeltaCounter = 3};
static const E2E_P05ConfigType config_P05 = {
    .Offset = 8, .DataLength = 240, .DataID = 0x1234, .MaxDeltaCounter = 3};
static const E2E_P06ConfigType config_P06 = {.Offset = 8,
                                             .MinDataLength = 120,
                                             .MaxDataLength = 248,
                                             .DataID = 0x1234,
                                             .MaxDeltaCounter = 3};
static const E2E_P07ConfigType config_P07 = {.DataID = 0x0a0b0c0d,
                                             .Offset = 16,
                                             .MinDataLength = 180,
                                             .MaxDataLength = 248,
                                             .MaxDeltaCounter = 3};
static const E2E_P08ConfigType config_P08 = {.DataID = 0x0a0b0c0d,
                                             .Offset = 16,
                                             .MinDataLength = 150,
                                             .MaxDataLength = 248,
                                             .MaxDeltaCounter = 3};
static const E2E_P11ConfigType config_P11 = {.CounterOffset = 24,
                                             .CRCOffset = 16,
                                             .DataID = 0x0123,
                                             .DataIDNibbleOffset = 28,
                                             .DataIDMode = E2E_P11_DATAID_NIBBLE,
                                             .DataLength = 240,
                                             .MaxDeltaCounter = 3};
static const E2E_P22ConfigType config_P22 = {
    .DataLength = 240,
    .DataIDList = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16},
    .MaxDeltaCounter = 3,
    .Offset = 8};

/* The counter `steps` after `from` in a profile whose largest counter is `top`. */
static uint32 ahead(uint32 from, uint32 steps, uint32 top) {
    return (uint32)(((uint64)from + steps) % ((uint64)top + 1));
}

#define RULES(P, top, counter_type, too_long, too_short)                                           \
    static void P##_refuses_null(void) {                                                           \
        E2E_##P##ProtectStateType sender = {5};                                                    \
        E2E_##P##CheckStateType receiver = {.Status = E2E_##P##STATUS_OK, .Counter = 5};           \
        uint8 data[BYTES] = {0};                                                                   \
        const uint8 zero[BYTES] = {0};                                                             \
        CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_##P##CheckConfig(NULL));                                 \
        CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_##P##ProtectInit(NULL));                                 \
        CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_##P##CheckInit(NULL));                                   \
        CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_##P##Protect(NULL, &sender, data, BYTES));               \
        CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_##P##Protect(&config_##P, NULL, data, BYTES));           \
        CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_##P##Protect(&config_##P, &sender, NULL, BYTES));        \
        CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_##P##Check(NULL, &receiver, data, BYTES));               \
        CHECK_EQ(E2E_E_INPUTERR_NULL, E2E_##P##Check(&config_##P, NULL, data, BYTES));             \
        CHECK_EQ(5, sender.Counter);                                                               \
        CHECK(receiver.Counter == 5 && receiver.Status == E2E_##P##STATUS_OK);                     \
        CHECK(memcmp(zero, data, BYTES) == 0);                                                     \
    }                                                                                              \
    static void P##_refuses_lengths_out_of_range(void) {                                           \
        E2E_##P##ProtectStateType sender = {5};                                                    \
        E2E_##P##CheckStateType receiver = {.Status = E2E_##P##STATUS_OK, .Counter = 5};           \
        uint8 data[BYTES + 2] = {0};                                                               \
        const uint8 zero[BYTES + 2] = {0};                                                         \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_##P##Protect(&config_##P, &sender, data, too_long));    \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_##P##Protect(&config_##P, &sender, data, too_short));   \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_##P##Protect(&config_##P, &sender, data, 0));           \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_##P##Check(&config_##P, &receiver, data, too_long));    \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_##P##Check(&config_##P, &receiver, data, too_short));   \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_##P##Check(&config_##P, &receiver, data, 0));           \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_##P##Check(&config_##P, &receiver, NULL, BYTES));       \
        CHECK_EQ(5, sender.Counter);                                                               \
        CHECK(receiver.Counter == 5 && receiver.Status == E2E_##P##STATUS_OK);                     \
        CHECK(memcmp(zero, data, sizeof data) == 0);                                               \
    }                                                                                              \
    static E2E_##P##CheckStatusType P##_receive(E2E_##P##CheckStateType *receiver,                 \
                                                uint32 counter) {                                  \
        const uint32 before = #P[1] == '2' ? ahead(counter, top, top) : counter;                   \
        E2E_##P##ProtectStateType sender = {(counter_type)before};                                 \
        uint8 data[BYTES] = {1, 2, 3};                                                             \
        CHECK_EQ(E2E_E_OK, E2E_##P##Protect(&config_##P, &sender, data, BYTES));                   \
        CHECK_EQ(E2E_E_OK, E2E_##P##Check(&config_##P, receiver, data, BYTES));                    \
        CHECK_EQ(counter, receiver->Counter);                                                      \
        return receiver->Status;                                                                   \
    }                                                                                              \
    static void P##_goes_through_every_status(void) {                                              \
        E2E_##P##CheckStateType receiver;                                                          \
        CHECK_EQ(E2E_E_OK, E2E_##P##CheckInit(&receiver));                                         \
        CHECK(receiver.Counter == (counter_type)(top) &&                                           \
              receiver.Status == E2E_##P##STATUS_ERROR);                                           \
        CHECK_EQ(E2E_E_OK, E2E_##P##Check(&config_##P, &receiver, NULL, 0));                       \
        CHECK(receiver.Counter == (counter_type)(top) &&                                           \
              receiver.Status == E2E_##P##STATUS_NONEWDATA);                                       \
        CHECK_EQ(E2E_##P##STATUS_OK, P##_receive(&receiver, 0));                                   \
        CHECK_EQ(E2E_##P##STATUS_REPEATED, P##_receive(&receiver, 0));                             \
        CHECK_EQ(E2E_##P##STATUS_OKSOMELOST, P##_receive(&receiver, 2));                           \
        CHECK_EQ(E2E_##P##STATUS_OKSOMELOST, P##_receive(&receiver, 5));                           \
        CHECK_EQ(E2E_##P##STATUS_WRONGSEQUENCE, P##_receive(&receiver, 9));                        \
        CHECK_EQ(E2E_##P##STATUS_OK, P##_receive(&receiver, 10));                                  \
        CHECK_EQ(E2E_##P##STATUS_WRONGSEQUENCE, P##_receive(&receiver, 9));                        \
        CHECK_EQ(E2E_##P##STATUS_WRONGSEQUENCE, P##_receive(&receiver, (top)-1U));                 \
        CHECK_EQ(E2E_##P##STATUS_OKSOMELOST, P##_receive(&receiver, 1));                           \
    }                                                                                              \
    static void P##_sees_every_single_flip(void) {                                                 \
        E2E_##P##ProtectStateType sender = {5};                                                    \
        uint8 data[BYTES] = {0x5a, 0xa5};                                                          \
        E2E_##P##Protect(&config_##P, &sender, data, BYTES);                                       \
        for (uint32 bit = 0; bit < 8 * BYTES; bit++) {                                             \
            E2E_##P##CheckStateType receiver = {.Status = E2E_##P##STATUS_OK, .Counter = 3};       \
            data[bit / 8] ^= (uint8)(1U << bit % 8);                                               \
            CHECK_EQ(E2E_E_OK, E2E_##P##Check(&config_##P, &receiver, data, BYTES));               \
            CHECK(receiver.Counter == 3 && receiver.Status == E2E_##P##STATUS_ERROR);              \
            data[bit / 8] ^= (uint8)(1U << bit % 8);                                               \
        }                                                                                          \
    }                                                                                              \
    static void P##_starts_at_0_and_wraps(void) {                                                  \
        E2E_##P##ProtectStateType sender = {7};                                                    \
        uint8 data[BYTES] = {0};                                                                   \
        CHECK_EQ(E2E_E_OK, E2E_##P##ProtectInit(&sender));                                         \
        CHECK_EQ(0, sender.Counter);                                                               \
        sender.Counter = (counter_type)(top);                                                      \
        CHECK_EQ(E2E_E_OK, E2E_##P##Protect(&config_##P, &sender, data, BYTES));                   \
        CHECK_EQ(0, sender.Counter);                                                               \
    }                                                                                              \
    static void P##_rules(void) {                                                                  \
        CHECK_EQ(E2E_E_OK, E2E_##P##CheckConfig(&config_##P));                                     \
        P##_refuses_null();                                                                        \
        P##_refuses_lengths_out_of_range();                                                        \
        P##_goes_through_every_status();                                                           \
        P##_sees_every_single_flip();                                                              \
        P##_starts_at_0_and_wraps();                                                               \
    }

RULES(P04, 0xFFFFU, uint16, 32, 14)
RULES(P44, 0xFFFFU, uint16, 32, 14)
RULES(P05, 0xFFU, uint8, 31, 29)
RULES(P06, 0xFFU, uint8, 32, 14)
RULES(P07, 0xFFFFFFFFU, uint32, 32, 22)
RULES(P08, 0xFFFFFFFFU, uint32, 32, 18)
RULES(P11, 14U, uint8, 31, 29)
RULES(P22, 15U, uint8, 31, 29)

/* A packet that ends inside its own header, though MinDataLength permits it. */
static void a_cut_header_is_refused_before_it_is_read(void) {
    E2E_P07ConfigType config = config_P07;
    E2E_P07ProtectStateType sender = {0};
    E2E_P07CheckStateType receiver = {.Status = E2E_P07STATUS_OK, .Counter = 0};
    uint8 data[21] = {0};
    config.MinDataLength = 0;
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P07Protect(&config, &sender, data, sizeof data));
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P07Check(&config, &receiver, data, sizeof data));
    config.Offset = 0xFFFFFFF8U;
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P07Check(&config, &receiver, data, sizeof data));
}

static void profile_11_refuses_fields_outside_the_data(void) {
    E2E_P11ProtectStateType sender = {0};
    uint8 data[BYTES] = {0};
    E2E_P11ConfigType config = config_P11;
    config.CRCOffset = 240;
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P11Protect(&config, &sender, data, BYTES));
    config = config_P11;
    config.CounterOffset = 240;
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P11Protect(&config, &sender, data, BYTES));
    config = config_P11;
    config.DataIDNibbleOffset = 240;
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P11Protect(&config, &sender, data, BYTES));
}

static void profile_11_takes_counter_15_for_an_error(void) {
    E2E_P11CheckStateType receiver = {.Status = E2E_P11STATUS_OK, .Counter = 14};
    E2E_P11ProtectStateType sender = {15};
    uint8 data[BYTES] = {0};
    E2E_P11Protect(&config_P11, &sender, data, BYTES);
    CHECK_EQ(15, data[3] & 0x0F);
    CHECK_EQ(E2E_E_OK, E2E_P11Check(&config_P11, &receiver, data, BYTES));
    CHECK(receiver.Status == E2E_P11STATUS_ERROR && receiver.Counter == 14);
}

#define WRONG(P, member, value)                                                                    \
    do {                                                                                           \
        E2E_##P##ConfigType changed = config_##P;                                                  \
        changed.member = (value);                                                                  \
        CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_##P##CheckConfig(&changed));                            \
    } while (0)

#define WRONG_RANGES(P)                                                                            \
    WRONG(P, Offset, 12);                                                                          \
    WRONG(P, Offset, 240);                                                                         \
    WRONG(P, MinDataLength, 32);                                                                   \
    WRONG(P, MaxDataLength, 112);                                                                  \
    WRONG(P, MaxDeltaCounter, 0)

static void configurations_out_of_range_are_named_wrong(void) {
    WRONG_RANGES(P04);
    WRONG_RANGES(P44);
    WRONG_RANGES(P06);
    WRONG_RANGES(P07);
    WRONG_RANGES(P08);
    WRONG(P04, MaxDataLength, 32776);
    WRONG(P06, MaxDataLength, 32776);
    WRONG(P44, MaxDataLength, 524288);
    WRONG(P05, Offset, 4);
    WRONG(P05, Offset, 224);
    WRONG(P05, DataLength, 236);
    WRONG(P05, DataLength, 16);
    WRONG(P05, DataLength, 32776);
    WRONG(P05, MaxDeltaCounter, 0);
    WRONG(P22, Offset, 4);
    WRONG(P22, Offset, 232);
    WRONG(P22, DataLength, 236);
    WRONG(P22, DataLength, 2056);
    WRONG(P22, MaxDeltaCounter, 0);
    WRONG(P22, MaxDeltaCounter, 16);
    WRONG(P11, DataLength, 8);
    WRONG(P11, DataLength, 248);
    WRONG(P11, DataLength, 236);
    WRONG(P11, CRCOffset, 20);
    WRONG(P11, CRCOffset, 240);
    WRONG(P11, CRCOffset, 24);
    WRONG(P11, CounterOffset, 26);
    WRONG(P11, CounterOffset, 20);
    WRONG(P11, CounterOffset, 28);
    WRONG(P11, DataIDNibbleOffset, 30);
    WRONG(P11, DataIDNibbleOffset, 240);
    WRONG(P11, DataID, 0x1123);
    WRONG(P11, MaxDeltaCounter, 0);
    WRONG(P11, MaxDeltaCounter, 15);
    WRONG(P11, DataIDMode, (E2E_P11DataIDMode)1);
}

int main(void) {
    P04_rules();
    P44_rules();
    P05_rules();
    P06_rules();
    P07_rules();
    P08_rules();
    P11_rules();
    P22_rules();
    a_cut_header_is_refused_before_it_is_read();
    profile_11_refuses_fields_outside_the_data();
    profile_11_takes_counter_15_for_an_error();
    configurations_out_of_range_are_named_wrong();
    return check_result();
}
