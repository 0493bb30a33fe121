/* The handle macros, with and without FC_DISABLE. */
#include "handle_test.h"

#include "check.h"
#include "fc.h"

static double probe(double value) {
    FC_PROBE_F64("speed", &value);
    return value;
}

static void a_handle_follows_its_identifier(void) {
    CHECK_BITS(probe(1), 1);
    fc_fault_id fault = fc_add_offset(NULL, "speed", 2);
    CHECK_BITS(probe(1), 3);
    CHECK_INT(fc_num_active(NULL, "speed"), 1);
    fc_remove(NULL, fault);
    CHECK_BITS(probe(1), 1);
    fc_add_offset(NULL, "speed", 5);
    fc_reset(NULL);
    CHECK_BITS(probe(1), 1);
    fc_add_offset(NULL, "speed", 5);
    CHECK_BITS(probe(1), 6);
    fc_reset(NULL);
}

#define CHECK_TYPE(macro, type, function)                                                          \
    do {                                                                                           \
        type by_macro = 1, by_function = 1;                                                        \
        macro("any", &by_macro);                                                                   \
        function(NULL, "any", &by_function);                                                       \
        CHECK(by_macro == by_function && by_macro != 1);                                           \
    } while (0)

static void every_type_has_a_macro(void) {
    fc_add_bitflip(NULL, "any", 0);
    CHECK_TYPE(FC_PROBE_F32, float, fc_probe_f32);
    CHECK_TYPE(FC_PROBE_F64, double, fc_probe_f64);
    CHECK_TYPE(FC_PROBE_I8, int8_t, fc_probe_i8);
    CHECK_TYPE(FC_PROBE_I16, int16_t, fc_probe_i16);
    CHECK_TYPE(FC_PROBE_I32, int32_t, fc_probe_i32);
    CHECK_TYPE(FC_PROBE_I64, int64_t, fc_probe_i64);
    CHECK_TYPE(FC_PROBE_U8, uint8_t, fc_probe_u8);
    CHECK_TYPE(FC_PROBE_U16, uint16_t, fc_probe_u16);
    CHECK_TYPE(FC_PROBE_U32, uint32_t, fc_probe_u32);
    CHECK_TYPE(FC_PROBE_U64, uint64_t, fc_probe_u64);
    CHECK_TYPE(FC_PROBE_BOOL, bool, fc_probe_bool);
    fc_reset(NULL);
}

static void disabled_macros_leave_the_value(void) {
    fc_add_offset(NULL, "off", 5);
    CHECK_BITS(probe_disabled(1), 1);
    fc_reset(NULL);
}

int main(void) {
    a_handle_follows_its_identifier();
    every_type_has_a_macro();
    disabled_macros_leave_the_value();
    return CHECK_RESULT();
}
