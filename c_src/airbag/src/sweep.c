/* One corruption mask against every first data byte. See airbag_sweep.h. */
#include "airbag_sweep.h"

#include "faultcheck_packet_wrapper.h"

enum { PACKET_BYTES = 4, SENDS = 4, FIRE_BYTE = 85, SECOND_BYTE = 170 };

static void arm(const uint8_t *mask) {
    faultcheck_packet_removeAllFaultsIdentifier(AIRBAG_CHANNEL);
    for (int byte = 0; byte < PACKET_BYTES; byte++)
        for (int bit = 0; bit < 8; bit++)
            if (mask[byte] >> bit & 1)
                faultcheck_packet_addFaultCorruptionBitFlip(AIRBAG_CHANNEL, byte, bit);
}

static int is_empty(const uint8_t *mask) {
    return mask[0] == 0 && mask[1] == 0 && mask[2] == 0 && mask[3] == 0;
}

/* Packets accepted so far, whatever the state of the counters. */
static uint64_t accepted_packets(void) {
    return airbag_seen.ok + airbag_seen.ok_some_lost + airbag_seen.initial + airbag_seen.sync;
}

static uint64_t send(uint8_t value) {
    const uint8_t data[2] = {value, SECOND_BYTE};
    uint64_t before = accepted_packets();
    application_init();
    for (int i = 0; i < SENDS; i++) {
        sensor_e2e(data);
        airbag_iteration_e2e();
    }
    return accepted_packets() - before;
}

airbag_sweep_result airbag_sweep(const uint8_t *mask) {
    airbag_sweep_result result = {0, 0, -1};
    int altered = !is_empty(mask);
    arm(mask);
    for (int value = 0; value < 256; value++) {
        if (value == FIRE_BYTE)
            continue;
        uint64_t accepted = send((uint8_t)value);
        if (altered && accepted > 0)
            result.accepted++;
        if (airbag_active) {
            result.fired++;
            result.fired_value = value;
        }
    }
    faultcheck_packet_removeAllFaultsIdentifier(AIRBAG_CHANNEL);
    return result;
}
