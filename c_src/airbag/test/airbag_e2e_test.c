/* The airbag with E2E profile 1, both variants. The masks and first packets were computed apart
 * from this code, from the CRC polynomial alone. */
#include "airbag.h"

#include <string.h>

#include "E2E_P01.h"
#include "check.h"
#include "faultcheck_packet_wrapper.h"

static const uint8_t fire[2] = {85, 170};

static void start(airbag_variant variant) {
    faultcheck_packet_removeAllFaults();
    airbag_iteration(); /* empties the channel */
    airbag_configure(variant, 2);
    application_init();
    airbag_clear_statuses();
}

static void sends(uint8_t value) {
    const uint8_t data[2] = {value, 170};
    sensor_e2e(data);
    airbag_iteration_e2e();
}

static void arm(const uint8_t mask[4]) {
    for (int byte = 0; byte < 4; byte++)
        for (int bit = 0; bit < 8; bit++)
            if (mask[byte] >> bit & 1)
                faultcheck_packet_addFaultCorruptionBitFlip(AIRBAG_CHANNEL, byte, bit);
}

static void packet_is(const char *expected) {
    char packet[256];
    int length = 0;
    sensor_e2e(fire);
    CHECK_INT(1, faultcheck_packet_getPacket(AIRBAG_CHANNEL, packet, &length));
    CHECK_INT(4, length);
    CHECK(memcmp(packet, expected, 4) == 0);
}

static void the_first_packets_of_the_recommended_variant(void) {
    start(AIRBAG_RECOMMENDED);
    packet_is("\x6d\x55\xaa\x00");
    packet_is("\x70\x55\xaa\x01");
    packet_is("\x57\x55\xaa\x02");
}

static void the_recommended_configuration_passes_its_check_and_the_thesis_one_does_not(void) {
    E2E_P01ConfigType config;
    memset(&config, 0, sizeof config);
    config.CounterOffset = 24;
    config.DataIDMode = E2E_P01_DATAID_BOTH;
    config.MaxDeltaCounterInit = 3;
    config.MaxNoNewOrRepeatedData = 14;
    config.DataID = 0x0123;
    config.DataLength = 32;
    CHECK_INT(E2E_E_OK, E2E_P01CheckConfig(&config));
    config.DataLength = 16;
    CHECK_INT(E2E_E_INPUTERR_WRONG, E2E_P01CheckConfig(&config));
}

static void fires_at_the_third_message(airbag_variant variant) {
    start(variant);
    sends(85);
    sends(85);
    CHECK_INT(0, airbag_active);
    sends(85);
    CHECK_INT(1, airbag_active);
}

static void the_first_packet_is_repeated_with_zeroed_states_and_initial_after_init(void) {
    start(AIRBAG_THESIS);
    sends(87);
    CHECK_INT(1, airbag_seen.repeated);
    start(AIRBAG_RECOMMENDED);
    sends(87);
    CHECK_INT(1, airbag_seen.initial);
    CHECK_INT(1, airbag_seen.no_new_data);
}

static void an_accepted_other_message_sets_the_count_to_zero(airbag_variant variant) {
    start(variant);
    sends(85);
    sends(85);
    CHECK_INT(1, activations);
    sends(87);
    CHECK_INT(0, activations);
    sends(85);
    CHECK_INT(0, airbag_active);
}

static void a_refused_packet_leaves_the_count_alone(airbag_variant variant) {
    start(variant);
    sends(85);
    sends(85);
    faultcheck_packet_addFaultCorruptionBitFlip(AIRBAG_CHANNEL, 1, 1);
    sends(85);
    CHECK_INT(1, airbag_seen.wrong_crc);
    CHECK_INT(1, activations);
}

/* A packet whose counter arrives as 15 is rejected with a stale status; the loop must go on. */
static void a_counter_of_fifteen_does_not_end_the_loop(airbag_variant variant) {
    static const char counter_15[4] = {0, 85, (char)170, 15};
    start(variant);
    sends(87);
    faultcheck_packet_addPacket(AIRBAG_CHANNEL, counter_15, 4);
    sensor_e2e(fire);
    sensor_e2e(fire);
    airbag_iteration_e2e();
    CHECK_INT(1, airbag_seen.rejected);
    CHECK_INT(2, airbag_seen.ok);
    CHECK_INT(1, airbag_active);
}

static void fires_under(airbag_variant variant, uint8_t value, uint32_t mask_bytes) {
    const uint8_t mask[4] = {(uint8_t)(mask_bytes >> 24), (uint8_t)(mask_bytes >> 16),
                             (uint8_t)(mask_bytes >> 8), (uint8_t)mask_bytes};
    start(variant);
    arm(mask);
    sends(value);
    sends(value);
    CHECK_INT(0, airbag_active);
    sends(value);
    CHECK_INT(1, airbag_active);
}

static void the_undetected_masks_fire_at_the_third_message(void) {
    fires_under(AIRBAG_THESIS, 21, 0x13400000);
    fires_under(AIRBAG_THESIS, 213, 0x26800000);
    fires_under(AIRBAG_THESIS, 214, 0x01830000);
    fires_under(AIRBAG_RECOMMENDED, 87, 0x03020000);
    fires_under(AIRBAG_RECOMMENDED, 21, 0x60400000);
    fires_under(AIRBAG_RECOMMENDED, 213, 0xc0800000);
    fires_under(AIRBAG_RECOMMENDED, 117, 0x30200000);
    fires_under(AIRBAG_RECOMMENDED, 84, 0x08010020);
    fires_under(AIRBAG_RECOMMENDED, 87, 0x10020040);
    fires_under(AIRBAG_RECOMMENDED, 81, 0x20040080);
}

/* From every state reachable by lost and altered packets 15 clean ones recover the receiver. */
static void fifteen_clean_messages_fire_after_faults(airbag_variant variant) {
    for (int bit = 0; bit < 32; bit++) {
        for (int before = 0; before < 20; before++) {
            start(variant);
            faultcheck_packet_addFaultCorruptionBitFlip(AIRBAG_CHANNEL, bit / 8, bit % 8);
            faultcheck_packet_addFaultRepeat(AIRBAG_CHANNEL, 3);
            for (int i = 0; i < before; i++)
                sends(87);
            CHECK_INT(0, airbag_active);
            faultcheck_packet_removeAllFaults();
            for (int i = 0; i < 15; i++)
                sensor_e2e(fire);
            airbag_iteration_e2e();
            CHECK_INT(1, airbag_active);
        }
    }
}

int main(void) {
    the_first_packets_of_the_recommended_variant();
    the_recommended_configuration_passes_its_check_and_the_thesis_one_does_not();
    the_first_packet_is_repeated_with_zeroed_states_and_initial_after_init();
    the_undetected_masks_fire_at_the_third_message();
    static const airbag_variant variants[] = {AIRBAG_THESIS, AIRBAG_RECOMMENDED};
    for (int i = 0; i < 2; i++) {
        fires_at_the_third_message(variants[i]);
        an_accepted_other_message_sets_the_count_to_zero(variants[i]);
        a_refused_packet_leaves_the_count_alone(variants[i]);
        a_counter_of_fifteen_does_not_end_the_loop(variants[i]);
        fifteen_clean_messages_fire_after_faults(variants[i]);
    }
    return check_result();
}
