/* The airbag without protection: counting, corruption, repetition. */
#include "airbag.h"

#include "check.h"
#include "faultcheck_packet_wrapper.h"

static const uint8_t fire[2] = {85, 170};
static const uint8_t quiet[2] = {87, 170};

static void start(int needed) {
    faultcheck_packet_removeAllFaults();
    airbag_iteration(); /* empties the channel */
    CHECK_INT(0, airbag_configure(AIRBAG_THESIS, needed));
    application_init();
}

static void sends(const uint8_t *data) {
    sensor(data);
    airbag_iteration();
}

static void fires_at_the_second_message_in_succession(void) {
    start(2);
    sends(fire);
    CHECK_INT(0, airbag_active);
    CHECK_INT(1, activations);
    sends(fire);
    CHECK_INT(1, airbag_active);
    sends(quiet);
    CHECK_INT(1, airbag_is_active());
}

static void another_message_sets_the_count_to_zero(void) {
    start(2);
    sends(fire);
    sends(quiet);
    CHECK_INT(0, activations);
    sends(fire);
    CHECK_INT(0, airbag_active);
}

static void a_packet_of_another_length_sets_the_count_to_zero(void) {
    start(2);
    sends(fire);
    faultcheck_packet_addPacket(AIRBAG_CHANNEL, "\x55\xaa\x55", 3);
    airbag_iteration();
    CHECK_INT(0, activations);
}

static void needs_as_many_messages_as_configured(void) {
    start(1);
    sends(fire);
    CHECK_INT(1, airbag_active);
    start(3);
    sends(fire);
    sends(fire);
    CHECK_INT(0, airbag_active);
    sends(fire);
    CHECK_INT(1, airbag_active);
}

static void one_corrupted_and_repeated_packet_fires(void) {
    start(2);
    faultcheck_packet_addFaultCorruptionBitFlip(AIRBAG_CHANNEL, 0, 1); /* 87 becomes 85 */
    faultcheck_packet_addFaultRepeat(AIRBAG_CHANNEL, 1);
    sends(quiet);
    CHECK_INT(1, airbag_active);
}

static void initialising_forgets_the_firing(void) {
    start(1);
    sends(fire);
    application_init();
    CHECK_INT(0, airbag_active);
    CHECK_INT(0, activations);
}

static void refuses_a_configuration_out_of_range(void) {
    start(2);
    CHECK_INT(-1, airbag_configure(AIRBAG_THESIS, 0));
    CHECK_INT(-1, airbag_configure((airbag_variant)2, 2));
    application_init();
    sends(fire);
    CHECK_INT(0, airbag_active);
}

int main(void) {
    fires_at_the_second_message_in_succession();
    another_message_sets_the_count_to_zero();
    a_packet_of_another_length_sets_the_count_to_zero();
    needs_as_many_messages_as_configured();
    one_corrupted_and_repeated_packet_fires();
    initialising_forgets_the_firing();
    refuses_a_configuration_out_of_range();
    return check_result();
}
