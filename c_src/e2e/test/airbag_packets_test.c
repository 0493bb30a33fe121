/* Profile 1 as the airbag uses it: first packets, and which bit flips its CRC cannot see (e2e.md
 * section 9). */
#include "E2E_P01.h"
#include "check.h"
#include <string.h>

static const E2E_P01ConfigType recommended = {.CounterOffset = 24,
                                              .CRCOffset = 0,
                                              .DataID = 0x0123,
                                              .DataIDMode = E2E_P01_DATAID_BOTH,
                                              .DataLength = 32,
                                              .MaxDeltaCounterInit = 3,
                                              .MaxNoNewOrRepeatedData = 14,
                                              .SyncCounterInit = 0};

static const E2E_P01ConfigType thesis = {.CounterOffset = 24,
                                         .CRCOffset = 0,
                                         .DataID = 0,
                                         .DataIDMode = E2E_P01_DATAID_BOTH,
                                         .DataLength = 16,
                                         .MaxDeltaCounterInit = 3,
                                         .MaxNoNewOrRepeatedData = 14,
                                         .SyncCounterInit = 0};

static void send(const E2E_P01ConfigType *config, uint8 counter, uint8 first, uint8 second,
                 uint8 packet[4]) {
    E2E_P01ProtectStateType sender = {counter};
    const uint8 bytes[4] = {0, first, second, 0};
    memcpy(packet, bytes, 4);
    CHECK_EQ(E2E_E_OK, E2E_P01Protect(config, &sender, packet));
}

/* The verdict of a receiver that has just seen the packet before. */
static E2E_P01CheckStatusType verdict(const E2E_P01ConfigType *config, uint8 last,
                                      const uint8 packet[4]) {
    E2E_P01CheckStateType receiver = {.LastValidCounter = last,
                                      .MaxDeltaCounter = config->MaxDeltaCounterInit,
                                      .NewDataAvailable = TRUE,
                                      .Status = E2E_P01STATUS_WRONGCRC};
    E2E_P01Check(config, &receiver, packet);
    return receiver.Status;
}

static void recommended_first_packets(void) {
    static const uint8 expected[3][4] = {
        {0x6d, 0x55, 0xaa, 0x00}, {0x70, 0x55, 0xaa, 0x01}, {0x57, 0x55, 0xaa, 0x02}};
    for (uint8 counter = 0; counter < 3; counter++) {
        uint8 packet[4];
        send(&recommended, counter, 85, 170, packet);
        CHECK(memcmp(expected[counter], packet, 4) == 0);
    }
}

static int bits_set(uint32 mask) {
    int bits = 0;
    for (; mask != 0; mask &= mask - 1) {
        bits++;
    }
    return bits;
}

static void flip(uint8 packet[4], uint32 mask) {
    for (int byte = 0; byte < 4; byte++) {
        packet[byte] ^= (uint8)(mask >> (8 * byte));
    }
}

/* Calls visit(mask) for every mask of exactly `flips` of the lowest `bits` bits. */
static void each_mask(int bits, int flips, void (*visit)(uint32)) {
    if (flips == 0) {
        visit(0);
        return;
    }
    const uint64 end = 1ULL << bits;
    uint64 mask = (1ULL << flips) - 1;
    while (mask < end) {
        visit((uint32)mask);
        const uint64 low = mask & (~mask + 1); /* the next larger number with as many bits set */
        const uint64 ripple = mask + low;
        mask = (((mask ^ ripple) >> 2) / low) | ripple;
    }
}

static uint8 sent[4];
static int undetected[5];

static void count_if_undetected(uint32 mask) {
    uint8 packet[4];
    memcpy(packet, sent, 4);
    flip(packet, mask);
    if ((packet[3] & 0x0F) == 15) {
        /* Never sent: the return value reports it, whatever the CRC says. But is the CRC right? */
        E2E_P01ProtectStateType sender = {15};
        uint8 again[4];
        memcpy(again, packet, 4);
        E2E_P01Protect(&recommended, &sender, again);
        undetected[bits_set(mask)] += memcmp(again, packet, 4) == 0;
        return;
    }
    undetected[bits_set(mask)] += verdict(&recommended, 0, packet) != E2E_P01STATUS_WRONGCRC;
}

/* The CRC is linear, so one packet stands for all. */
static void with_32_bits_0_0_18_128_masks_are_undetected(void) {
    send(&recommended, 1, 87, 170, sent);
    for (int flips = 1; flips <= 4; flips++) {
        each_mask(32, flips, count_if_undetected);
    }
    CHECK_EQ(0, undetected[1]);
    CHECK_EQ(0, undetected[2]);
    CHECK_EQ(18, undetected[3]);
    CHECK_EQ(128, undetected[4]);
}

static struct {
    uint8 x;
    uint32 mask;
} found[16];
static int found_count;
static uint8 current_x;

static void note_if_it_becomes_the_firing_packet(uint32 mask) {
    uint8 packet[4];
    memcpy(packet, sent, 4);
    flip(packet, mask);
    if (packet[1] == 85 && packet[2] == 170 && verdict(&thesis, 0, packet) == E2E_P01STATUS_OK &&
        found_count < 16) {
        found[found_count].x = current_x;
        found[found_count].mask = mask;
        found_count++;
    }
}

/* Only bytes 0 and 1 are altered; what the thesis could not have met in 100 000 tests. */
static void with_16_bits_exactly_three_masks_fire_the_airbag(void) {
    for (int x = 0; x < 256; x++) {
        if (x == 85) {
            continue;
        }
        current_x = (uint8)x;
        send(&thesis, 1, current_x, 170, sent);
        for (int flips = 0; flips <= 4; flips++) {
            each_mask(16, flips, note_if_it_becomes_the_firing_packet);
        }
    }
    CHECK_EQ(3, found_count);
    CHECK(found[0].x == 21 && found[0].mask == 0x4013);
    CHECK(found[1].x == 213 && found[1].mask == 0x8026);
    CHECK(found[2].x == 214 && found[2].mask == 0x8301);
}

static void with_16_bits_the_second_byte_and_the_counter_are_unprotected(void) {
    send(&thesis, 1, 87, 170, sent);
    sent[2] ^= 0xFF;
    CHECK_EQ(E2E_P01STATUS_OK, verdict(&thesis, 0, sent));
    sent[3] ^= 0x02;
    CHECK_EQ(E2E_P01STATUS_OKSOMELOST, verdict(&thesis, 0, sent));
}

/* With DataLength 32: the documented masks that turn [x,170] into [85,170], counter intact. */
static void documented_triples_pass_the_recommended_check(void) {
    static const struct {
        uint8 x;
        uint8 mask[4];
    } triples[] = {{87, {0x03, 0x02, 0x00, 0x00}},  {21, {0x60, 0x40, 0x00, 0x00}},
                   {213, {0xc0, 0x80, 0x00, 0x00}}, {117, {0x30, 0x20, 0x00, 0x00}},
                   {84, {0x08, 0x01, 0x00, 0x20}},  {87, {0x10, 0x02, 0x00, 0x40}},
                   {81, {0x20, 0x04, 0x00, 0x80}}};
    for (size_t i = 0; i < sizeof triples / sizeof triples[0]; i++) {
        uint8 packet[4];
        send(&recommended, 1, triples[i].x, 170, packet);
        for (int byte = 0; byte < 4; byte++) {
            packet[byte] ^= triples[i].mask[byte];
        }
        CHECK_EQ(85, packet[1]);
        CHECK_EQ(1, packet[3] & 0x0F);
        CHECK_EQ(E2E_P01STATUS_OK, verdict(&recommended, 0, packet));
    }
}

static void an_all_zero_packet_is_valid_with_data_id_0(void) {
    const uint8 zero[4] = {0, 0, 0, 0};
    CHECK_EQ(E2E_P01STATUS_REPEATED, verdict(&thesis, 0, zero));
    CHECK_EQ(E2E_P01STATUS_WRONGCRC, verdict(&recommended, 0, zero));
}

static void check_config_tells_the_two_apart(void) {
    CHECK_EQ(E2E_E_INPUTERR_WRONG, E2E_P01CheckConfig(&thesis));
    CHECK_EQ(E2E_E_OK, E2E_P01CheckConfig(&recommended));
}

int main(void) {
    recommended_first_packets();
    with_32_bits_0_0_18_128_masks_are_undetected();
    with_16_bits_exactly_three_masks_fire_the_airbag();
    with_16_bits_the_second_byte_and_the_counter_are_unprotected();
    documented_triples_pass_the_recommended_check();
    an_all_zero_packet_is_valid_with_data_id_0();
    check_config_tells_the_two_apart();
    return check_result();
}
