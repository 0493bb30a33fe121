/* Probes of every type (7.2 of the reference). */
#include "errors.h"

#include <math.h>

static fc_context *ctx;

static void start(void) {
    fc_reset(ctx);
    errors_start(ctx);
}

#define PROBE(suffix, type)                                                                        \
    static type probe_##suffix(type value) {                                                       \
        fc_probe_##suffix(ctx, "p", &value);                                                       \
        return value;                                                                              \
    }
PROBE(f32, float)
PROBE(f64, double)
PROBE(i8, int8_t)
PROBE(i16, int16_t)
PROBE(i32, int32_t)
PROBE(i64, int64_t)
PROBE(u8, uint8_t)
PROBE(u16, uint16_t)
PROBE(u32, uint32_t)
PROBE(u64, uint64_t)
PROBE(bool, bool)

static void an_offset_saturates_each_type(void) {
    start();
    fc_add_offset(ctx, "p", 1e30);
    CHECK_INT(probe_i8(1), INT8_MAX);
    CHECK_INT(probe_i16(1), INT16_MAX);
    CHECK_INT(probe_i32(1), INT32_MAX);
    CHECK_INT(probe_i64(1), INT64_MAX);
    CHECK_INT(probe_u8(1), UINT8_MAX);
    CHECK_INT(probe_u16(1), UINT16_MAX);
    CHECK_INT(probe_u32(1), UINT32_MAX);
    CHECK(probe_u64(1) == UINT64_MAX);
    CHECK(probe_bool(false));
    start();
    fc_add_offset(ctx, "p", -1e30);
    CHECK_INT(probe_i8(1), INT8_MIN);
    CHECK_INT(probe_i16(1), INT16_MIN);
    CHECK_INT(probe_i32(1), INT32_MIN);
    CHECK(probe_i64(1) == INT64_MIN);
    CHECK_INT(probe_u8(1), 0);
    CHECK_INT(probe_u16(1), 0);
    CHECK_INT(probe_u32(1), 0);
    CHECK_INT(probe_u64(1), 0);
    CHECK_NO_ERROR();
}

static void wide_integers_are_exact(void) {
    const int64_t big = INT64_C(9007199254740993); /* 2^53 + 1: no double has it */
    start();
    fc_add_offset(ctx, "p", 1);
    CHECK_INT(probe_i64(big), big + 1);
    CHECK(probe_u64(UINT64_MAX - 1) == UINT64_MAX);
    CHECK(probe_u64(UINT64_MAX) == UINT64_MAX);
    CHECK_INT(probe_i64(INT64_MAX), INT64_MAX);
    start();
    fc_add_offset(ctx, "p", 0x1p63); /* beyond int64_t itself */
    CHECK_INT(probe_i64(-2), INT64_MAX - 1);
    CHECK(probe_u64(1) == (UINT64_C(1) << 63) + 1);
    start();
    fc_add_amplification(ctx, "p", 3);
    CHECK_INT(probe_i64(big), 3 * big);
    CHECK(probe_i64(INT64_MIN) == INT64_MIN);
    CHECK(probe_u64(UINT64_MAX / 3) == UINT64_MAX);
    start();
    fc_add_amplification(ctx, "p", 0.5); /* through double */
    CHECK_INT(probe_i64(big), big / 2);
    start();
    fc_add_set_to(ctx, "p", -1);
    CHECK_INT(probe_u64(7), 0);
    CHECK_INT(probe_i64(7), -1);
    CHECK_NO_ERROR();
}

static void a_float_is_rounded_once(void) {
    start();
    fc_add_offset(ctx, "p", 0.1);
    CHECK_BITS(probe_f32(1), (float)(1.0 + 0.1));
    start();
    fc_add_set_to(ctx, "p", 0.1);
    CHECK_BITS(probe_f32(1), 0.1f);
    start();
    fc_add_amplification(ctx, "p", 1e300);
    CHECK_BITS(probe_f32(1), INFINITY);
    CHECK_BITS(probe_f64(1), 1e300);
}

static void bits_beyond_the_width_are_skipped(void) {
    const struct {
        int width;
        int code;
    } rows[] = {{1, FC_OK}, {8, FC_OK}, {16, FC_OK}, {32, FC_OK}, {64, FC_OK}};
    for (size_t row = 0; row < 5; row++) {
        const int width = rows[row].width;
        start();
        fc_add_bitflip(ctx, "p", width - 1);
        bool b = false;
        int8_t i8 = 0;
        int16_t i16 = 0;
        int32_t i32 = 0;
        int64_t i64 = 0;
        uint8_t u8 = 0;
        uint16_t u16 = 0;
        uint32_t u32 = 0;
        uint64_t u64 = 0;
        float f32 = 0;
        double f64 = 0;
        CHECK_INT(fc_probe_bool(ctx, "p", &b), width <= 1 ? FC_OK : FC_E_BIT);
        CHECK_INT(fc_probe_i8(ctx, "p", &i8), width <= 8 ? FC_OK : FC_E_BIT);
        CHECK_INT(fc_probe_u8(ctx, "p", &u8), width <= 8 ? FC_OK : FC_E_BIT);
        CHECK_INT(fc_probe_i16(ctx, "p", &i16), width <= 16 ? FC_OK : FC_E_BIT);
        CHECK_INT(fc_probe_u16(ctx, "p", &u16), width <= 16 ? FC_OK : FC_E_BIT);
        CHECK_INT(fc_probe_i32(ctx, "p", &i32), width <= 32 ? FC_OK : FC_E_BIT);
        CHECK_INT(fc_probe_u32(ctx, "p", &u32), width <= 32 ? FC_OK : FC_E_BIT);
        CHECK_INT(fc_probe_f32(ctx, "p", &f32), width <= 32 ? FC_OK : FC_E_BIT);
        CHECK_INT(fc_probe_i64(ctx, "p", &i64), FC_OK);
        CHECK_INT(fc_probe_u64(ctx, "p", &u64), FC_OK);
        CHECK_INT(fc_probe_f64(ctx, "p", &f64), FC_OK);
        CHECK_INT(b, width <= 1);
        CHECK_INT(i8, width <= 8 ? (int8_t)(1u << (width - 1)) : 0);
        CHECK_INT(u8, width <= 8 ? 1u << (width - 1) : 0);
        CHECK_INT(i16, width <= 16 ? (int16_t)(1u << (width - 1)) : 0);
        CHECK_INT(u16, width <= 16 ? 1u << (width - 1) : 0);
        CHECK_INT(i32, width <= 32 ? (int32_t)(1u << (width - 1)) : 0);
        CHECK_INT(u32, width <= 32 ? 1u << (width - 1) : 0);
        CHECK(u64 == UINT64_C(1) << (width - 1));
        CHECK(i64 == (int64_t)(UINT64_C(1) << (width - 1)));
    }
}

static void a_bool_computes_on_0_and_1(void) {
    start();
    fc_add_offset(ctx, "p", -1);
    CHECK_INT(probe_bool(true), false);
    CHECK_INT(probe_bool(false), true);
    start();
    fc_add_amplification(ctx, "p", 0.25);
    CHECK_INT(probe_bool(true), true);
    start();
    fc_add_set_to(ctx, "p", 0);
    CHECK_INT(probe_bool(true), false);
    CHECK_NO_ERROR();
    start();
    fc_add_set_to(ctx, "p", NAN);
    CHECK_INT(probe_bool(true), true);
    CHECK_ERROR(FC_E_VALUE, "bool");
}

static void bytes_are_one_long_row_of_bits(void) {
    unsigned char data[20] = {0};
    start();
    fc_add_bitflip(ctx, "p", 8 * 13 + 5);
    CHECK_INT(fc_probe_bytes(ctx, "p", data, sizeof data), FC_OK);
    for (int at = 0; at < 20; at++)
        CHECK_INT(data[at], at == 13 ? 1 << 5 : 0);
    CHECK_INT(fc_probe_bytes(ctx, "p", data, 13), FC_E_BIT);
    CHECK_ERROR(FC_E_BIT, "no bit 109");
    CHECK_INT(fc_probe_bytes(ctx, "p", NULL, 0), FC_E_BIT);
    CHECK_ERROR(FC_E_BIT, "bytes");
}

static void bytes_are_filled_held_and_not_computed(void) {
    unsigned char data[4] = {1, 2, 3, 4};
    start();
    fc_add_set_to(ctx, "p", 255);
    CHECK_INT(fc_probe_bytes(ctx, "p", data, 4), FC_OK);
    CHECK(memcmp(data, "\xff\xff\xff\xff", 4) == 0);
    start();
    fc_add_set_to(ctx, "p", 256);
    CHECK_INT(fc_probe_bytes(ctx, "p", data, 4), FC_E_VALUE);
    CHECK_ERROR(FC_E_VALUE, "bytes");
    start();
    fc_add_stuck(ctx, "p");
    fc_probe_bytes(ctx, "p", "abcd", 0); /* an empty first call holds nothing */
    memcpy(data, "abcd", 4);
    fc_probe_bytes(ctx, "p", data, 4);
    CHECK(memcmp(data, "abcd", 4) == 0);
    start();
    fc_add_stuck(ctx, "p");
    fc_probe_bytes(ctx, "p", data, 4);
    memcpy(data, "wxyz", 4);
    fc_probe_bytes(ctx, "p", data, 4);
    CHECK(memcmp(data, "abcd", 4) == 0);
    CHECK_NO_ERROR();
    start();
    fc_add_offset(ctx, "p", 1);
    CHECK_INT(fc_probe_bytes(ctx, "p", data, 4), FC_E_TYPE);
    CHECK_ERROR(FC_E_TYPE, "bytes");
    CHECK(memcmp(data, "abcd", 4) == 0);
}

static void one_identifier_serves_several_types(void) {
    start();
    fc_fault_id fault = fc_add_offset(ctx, "p", 1);
    fc_trigger_duration(ctx, fault, 3);
    CHECK_INT(probe_i32(0), 1);
    CHECK_BITS(probe_f64(0), 1);
    CHECK_INT(probe_u8(0), 1);
    CHECK_INT(probe_i32(0), 0);
}

int main(void) {
    ctx = fc_new(NULL);
    an_offset_saturates_each_type();
    wide_integers_are_exact();
    a_float_is_rounded_once();
    bits_beyond_the_width_are_skipped();
    a_bool_computes_on_0_and_1();
    bytes_are_one_long_row_of_bits();
    bytes_are_filled_held_and_not_computed();
    one_identifier_serves_several_types();
    fc_free(ctx);
    return CHECK_RESULT();
}
