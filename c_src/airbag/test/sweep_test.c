/* The sweep over one mask; expected values from the CRC polynomial alone. */
#include "airbag_sweep.h"

#include "check.h"

static airbag_sweep_result sweep(airbag_variant variant, uint8_t b0, uint8_t b1, uint8_t b2,
                                 uint8_t b3) {
    const uint8_t mask[4] = {b0, b1, b2, b3};
    airbag_configure(variant, 2);
    return airbag_sweep(mask);
}

static void no_fault_accepts_nothing_altered_and_never_fires(airbag_variant variant) {
    airbag_sweep_result result = sweep(variant, 0, 0, 0, 0);
    CHECK_INT(0, result.accepted);
    CHECK_INT(0, result.fired);
    CHECK_INT(-1, result.fired_value);
}

static void a_detected_mask_is_never_accepted(airbag_variant variant) {
    airbag_sweep_result result = sweep(variant, 0, 2, 0, 0);
    CHECK_INT(0, result.accepted);
    CHECK_INT(0, result.fired);
}

static void an_undetected_mask_is_accepted_for_every_value_and_fires_for_one(void) {
    airbag_sweep_result thesis = sweep(AIRBAG_THESIS, 0x13, 0x40, 0, 0);
    CHECK_INT(255, thesis.accepted);
    CHECK_INT(1, thesis.fired);
    CHECK_INT(21, thesis.fired_value);
    airbag_sweep_result recommended = sweep(AIRBAG_RECOMMENDED, 0x03, 0x02, 0, 0);
    CHECK_INT(255, recommended.accepted);
    CHECK_INT(1, recommended.fired);
    CHECK_INT(87, recommended.fired_value);
}

static void the_second_byte_is_open_in_the_thesis_variant(void) {
    airbag_sweep_result result = sweep(AIRBAG_THESIS, 0, 0, 1, 0);
    CHECK_INT(255, result.accepted);
    CHECK_INT(0, result.fired);
}

int main(void) {
    no_fault_accepts_nothing_altered_and_never_fires(AIRBAG_THESIS);
    no_fault_accepts_nothing_altered_and_never_fires(AIRBAG_RECOMMENDED);
    a_detected_mask_is_never_accepted(AIRBAG_THESIS);
    a_detected_mask_is_never_accepted(AIRBAG_RECOMMENDED);
    an_undetected_mask_is_accepted_for_every_value_and_fires_for_one();
    the_second_byte_is_open_in_the_thesis_variant();
    return check_result();
}
