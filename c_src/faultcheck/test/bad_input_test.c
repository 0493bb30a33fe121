/* Bad input: each error code, NULL wherever a pointer goes in, NaN and infinities wherever a number
 * does, lengths of 0 and huge ones, indexes out of range, names of any bytes. Always the error that
 * the header tells, and nothing has changed. */
#include "errors.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

static fc_context *ctx;

static void start(void) {
    fc_free(ctx);
    ctx = fc_new(NULL);
    errors_start(ctx);
}

static void append(void *user, const char *line) {
    char *text = user;
    strncat(text, line, 20000 - strlen(text) - 1);
}

static void ignore_listed(void *user, const fc_listed *listed) {
    (void)user;
    (void)listed;
}

static void ignore_divergence(void *user, const fc_divergence *divergence) {
    (void)user;
    (void)divergence;
}

/* The call gives the code and one error with that text, and leaves the listing as it was. */
static char listing_before[20000];
static char listing_after[20000];
#define REFUSED(call, code, part)                                                                  \
    do {                                                                                           \
        listing_before[0] = listing_after[0] = '\0';                                               \
        CHECK_INT(fc_dump_json(ctx, append, listing_before), FC_OK);                               \
        CHECK_INT(call, code);                                                                     \
        CHECK_ERROR(code, part);                                                                   \
        CHECK_INT(fc_dump_json(ctx, append, listing_after), FC_OK);                                \
        CHECK(strcmp(listing_before, listing_after) == 0);                                         \
    } while (0)

/* All but FC_E_NOMEM, which memory_test.cpp and its sisters provoke. */
static void each_code(void) {
    start();
    int8_t small = 0;
    size_t len = 0;
    fc_channel_put(ctx, "c", "abc", 3);
    REFUSED(fc_probe_i8(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_add_bitflip(ctx, "p", -1), FC_E_BIT, "bit");
    REFUSED(fc_channel_add_corruption(ctx, "c", -1, 0), FC_E_INDEX, "below 0");
    REFUSED(fc_remove(ctx, 77), FC_E_NO_FAULT, "77");
    REFUSED(fc_channel_get(ctx, "c", "", &small, 1, &len), FC_E_SPACE, "does not fit");
    REFUSED(fc_channel_depth(ctx, "c", "nobody"), FC_E_RECEIVER, "receiver");
    REFUSED(fc_record_start(ctx, "/nowhere/at/all"), FC_E_IO, "/nowhere/at/all");
    CHECK_INT(len, 3);
    fc_add_set_to(ctx, "nan", NAN);
    CHECK_INT(fc_probe_i8(ctx, "nan", &small), FC_E_VALUE);
    CHECK_ERROR(FC_E_VALUE, "nan");
    fc_add_offset(ctx, "bytes", 1);
    CHECK_INT(fc_probe_bytes(ctx, "bytes", &small, 1), FC_E_TYPE);
    CHECK_ERROR(FC_E_TYPE, "bytes");
    fc_channel_add_block_put(ctx, "c");
    CHECK_INT(fc_channel_put(ctx, "c", "d", 1), FC_E_BLOCKED);
    CHECK_ERROR(FC_E_BLOCKED, "blocked");
    errors_start(NULL);
    CHECK_INT(fc_record_text("FCREC002", 8, append, listing_after), FC_E_FORMAT);
    CHECK_ERROR(FC_E_FORMAT, "FCREC001");
}

static void every_code_has_a_name(void) {
    CHECK(strcmp(fc_error_name(FC_OK), "FC_OK") == 0);
    for (int code = -1; code >= FC_E_FORMAT; --code) {
        CHECK(strncmp(fc_error_name(code), "FC_E_", 5) == 0);
        CHECK(strcmp(fc_error_name(code), "FC_E_UNKNOWN") != 0);
        for (int other = code + 1; other < 0; ++other)
            CHECK(strcmp(fc_error_name(code), fc_error_name(other)) != 0);
    }
    CHECK(strcmp(fc_error_name(FC_E_FORMAT - 1), "FC_E_UNKNOWN") == 0);
    CHECK(strcmp(fc_error_name(1), "FC_E_UNKNOWN") == 0);
    CHECK(strcmp(fc_error_name(INT_MIN), "FC_E_UNKNOWN") == 0);
}

static void null_values(void) {
    start();
    fc_add_offset(ctx, "p", 1);
    REFUSED(fc_probe_f32(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_f64(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_i8(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_i16(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_i32(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_i64(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_u8(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_u16(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_u32(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_u64(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_bool(ctx, "p", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_probe_bytes(ctx, "p", NULL, 1), FC_E_ARG, "NULL");
    REFUSED(fc_monitor_bytes(ctx, "p", NULL, 1), FC_E_ARG, "NULL");
    REFUSED(fc_channel_put(ctx, "c", NULL, 1), FC_E_ARG, "NULL");
    REFUSED(fc_channel_get(ctx, "c", "", NULL, 1, NULL), FC_E_ARG, "NULL");
}

static void null_parameters(void) {
    start();
    const fc_model model = {FC_OFFSET, 1, 0, 0};
    const fc_field field = {0, FC_U8, false, 0};
    const fc_fault_id fault = fc_add_offset(ctx, "p", 1);
    REFUSED(fc_add_model(ctx, "q", NULL), FC_E_ARG, "NULL");
    REFUSED(fc_channel_add_field(ctx, "c", NULL, &model), FC_E_ARG, "NULL");
    REFUSED(fc_channel_add_field(ctx, "c", &field, NULL), FC_E_ARG, "NULL");
    REFUSED(fc_channel_add_insert(ctx, "c", NULL, 1, 1), FC_E_ARG, "NULL");
    REFUSED(fc_channel_add_asymmetric(ctx, "c", NULL, 1, &field, &model), FC_E_ARG, "NULL");
    REFUSED(fc_channel_add_asymmetric(ctx, "c", NULL, 0, NULL, NULL), FC_E_ARG, "NULL");
    REFUSED(fc_channel_add_subset(ctx, "c", NULL, 1), FC_E_ARG, "NULL");
    REFUSED(fc_trigger_when(ctx, fault, NULL, NULL), FC_E_ARG, "NULL");
    REFUSED(fc_list(ctx, NULL, NULL), FC_E_ARG, "NULL");
    REFUSED(fc_dump_json(ctx, NULL, NULL), FC_E_ARG, "NULL");
    CHECK_INT(fc_record_start(ctx, NULL), FC_OK);
    CHECK(fc_record_copy(ctx, NULL, SIZE_MAX) > 0);
    CHECK_NO_ERROR();
}

static void null_recordings(void) {
    errors_start(NULL);
    CHECK_INT(fc_record_text(NULL, 1, append, listing_after), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "NULL");
    CHECK_INT(fc_record_text("FCREC001", 8, NULL, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "NULL");
    CHECK_INT(fc_record_text(NULL, 0, append, listing_after), FC_E_FORMAT);
    CHECK_ERROR(FC_E_FORMAT, "recording");
    CHECK_INT(fc_compare(NULL, 1, "", 0, NULL, ignore_divergence, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "NULL");
    CHECK_INT(fc_compare("", 0, NULL, 1, NULL, ignore_divergence, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "NULL");
    CHECK(fc_comparison_new(NULL, 1, "", 0, NULL) == NULL);
    CHECK_ERROR(FC_E_ARG, "NULL");
    CHECK(fc_comparison_new("FCREC001", 8, "FCREC001N", 9, NULL) == NULL);
    CHECK_ERROR(FC_E_FORMAT, "recording of the run");
    fc_comparison_free(NULL);
    CHECK_INT(fc_compare("FCREC001", 8, "FCREC001", 8, NULL, NULL, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "NULL");
    CHECK_INT(fc_compare("FCREC001", 8, "FCREC001", 8, NULL, ignore_divergence, NULL), 0);
    const double bad[] = {NAN, -1, -INFINITY};
    for (size_t at = 0; at < sizeof bad / sizeof *bad; ++at) {
        const fc_tolerance absolute = {bad[at], 0};
        const fc_tolerance relative = {0, bad[at]};
        CHECK_INT(fc_compare("FCREC001", 8, "FCREC001", 8, &absolute, ignore_divergence, NULL),
                  FC_E_ARG);
        CHECK_ERROR(FC_E_ARG, ">= 0");
        CHECK_INT(fc_compare("FCREC001", 8, "FCREC001", 8, &relative, ignore_divergence, NULL),
                  FC_E_ARG);
        CHECK_ERROR(FC_E_ARG, ">= 0");
    }
}

/* NULL names are empty ones, NULL callbacks the default, a NULL context the default one. */
static void null_that_is_meant(void) {
    start();
    int32_t value = 0;
    CHECK(fc_add_offset(ctx, NULL, 1) > 0);
    CHECK_INT(fc_probe_i32(ctx, "", &value), FC_OK);
    CHECK_INT(value, 1);
    CHECK_INT(fc_probe_i32(ctx, NULL, &value), FC_OK);
    CHECK_INT(value, 2);
    CHECK_INT(fc_channel_put(ctx, NULL, NULL, 0), FC_OK);
    CHECK_INT(fc_channel_depth(ctx, "", NULL), 1);
    CHECK_INT(fc_channel_get(ctx, "", NULL, NULL, 0, NULL), 1);
    CHECK_INT(fc_monitor_bytes(ctx, NULL, NULL, 0), FC_OK);
    CHECK_INT(fc_probe_bytes(ctx, "b", NULL, 0), FC_OK);
    CHECK(fc_channel_add_misroute(ctx, "c", NULL) > 0);
    CHECK_INT(fc_channel_subscribe(ctx, "c", NULL), FC_OK);
    CHECK_NO_ERROR();
    fc_set_clock(ctx, NULL, NULL);
    CHECK(fc_now(ctx) > 0);
}

/* Which parameters may be NaN or infinite: what fc_fault.h says of fc_add_model. */
static void numbers_that_are_none(void) {
    static const struct {
        int kind;
        bool nan_a, nan_b, infinite_a, infinite_b; /* allowed */
    } kinds[] = {
        {FC_AMPLIFICATION, true, true, true, true}, {FC_OFFSET, true, true, true, true},
        {FC_SET_TO, true, true, true, true},        {FC_NOISE_UNIFORM, false, true, true, true},
        {FC_NOISE_GAUSS, false, true, true, true},  {FC_RANDOM_OFFSET, false, false, false, true},
        {FC_DRIFT, false, false, true, true},       {FC_DRIFT_TIMED, false, false, true, true},
        {FC_RAMP, false, true, true, true},         {FC_QUANTISE, false, true, true, true},
        {FC_DEAD_ZONE, false, false, true, true},   {FC_SATURATE, false, false, false, true},
        {FC_OSCILLATE, false, true, true, true},    {FC_DROPOUT, false, true, false, true},
        {FC_SPIKE, false, false, false, true},
    };
    for (size_t at = 0; at < sizeof kinds / sizeof *kinds; ++at) {
        const double given[][2] = {{NAN, 1}, {1, NAN}, {INFINITY, 1}, {1, INFINITY}};
        const bool allowed[] = {kinds[at].nan_a, kinds[at].nan_b, kinds[at].infinite_a,
                                kinds[at].infinite_b};
        for (int which = 0; which < 4; ++which) {
            start();
            const fc_model model = {kinds[at].kind, given[which][0], given[which][1], 1};
            if (allowed[which]) {
                CHECK(fc_add_model(ctx, "p", &model) > 0);
                float single = 1;
                double value = 1;
                int64_t integer = 1;
                /* Whatever comes out, an integer is one. */
                fc_probe_f32(ctx, "p", &single);
                fc_probe_f64(ctx, "p", &value);
                const int code = fc_probe_i64(ctx, "p", &integer);
                CHECK(code == FC_OK || (code == FC_E_VALUE && integer == 1));
            } else {
                REFUSED(fc_add_model(ctx, "p", &model), FC_E_ARG, "fault not added");
            }
        }
    }
}

static void numbers_out_of_range(void) {
    start();
    const fc_fault_id fault = fc_add_offset(ctx, "p", 1);
    const double chances[] = {NAN, -0.001, 1.001, INFINITY, -INFINITY};
    for (size_t at = 0; at < sizeof chances / sizeof *chances; ++at) {
        REFUSED(fc_trigger_random(ctx, fault, chances[at]), FC_E_ARG, "0..1");
        REFUSED(fc_add_dropout(ctx, "p", chances[at], FC_HOLD), FC_E_ARG, "0..1");
        REFUSED(fc_add_spike(ctx, "p", chances[at], 1), FC_E_ARG, "0..1");
    }
    const fc_model no_model = {999, 0, 0, 0};
    const fc_model negative_model = {-1, 0, 0, 0};
    const fc_field no_type = {0, (fc_type)99, false, 0};
    const fc_field byte = {0, FC_U8, false, 0};
    REFUSED(fc_add_model(ctx, "p", &no_model), FC_E_ARG, "no such model");
    REFUSED(fc_add_model(ctx, "p", &negative_model), FC_E_ARG, "no such model");
    REFUSED(fc_channel_add_field(ctx, "c", &byte, &no_model), FC_E_ARG, "no such model");
    REFUSED(fc_channel_add_field(ctx, "c", &no_type, &no_model), FC_E_ARG, "no such type");
    REFUSED(fc_add_dropout(ctx, "p", 0.5, 3), FC_E_ARG, "FC_HOLD");
    REFUSED(fc_add_dropout(ctx, "p", 0.5, -1), FC_E_ARG, "FC_HOLD");
    REFUSED(fc_add_bitflip(ctx, "p", INT_MIN), FC_E_BIT, "below 0");
    REFUSED(fc_add_stuck_bit(ctx, "p", INT_MIN, true), FC_E_BIT, "below 0");
    REFUSED(fc_add_ramp(ctx, "p", 1, INT64_MIN), FC_E_ARG, ">= 1");
    REFUSED(fc_add_delay(ctx, "p", INT64_MIN), FC_E_ARG, "below 0");
    REFUSED(fc_add_oscillate(ctx, "p", 1, 0), FC_E_ARG, ">= 1");
    REFUSED(fc_channel_add_corruption(ctx, "c", INT_MIN, 0), FC_E_INDEX, "below 0");
    REFUSED(fc_channel_add_corruption(ctx, "c", 0, 8), FC_E_BIT, "0..7");
    REFUSED(fc_channel_add_corruption(ctx, "c", 0, INT_MIN), FC_E_BIT, "0..7");
    REFUSED(fc_channel_add_drop(ctx, "c", INT64_MIN), FC_E_ARG, "below 0");
    REFUSED(fc_channel_add_repeat(ctx, "c", INT64_MIN), FC_E_ARG, "below 0");
    REFUSED(fc_channel_add_insert(ctx, "c", "x", 1, INT64_MIN), FC_E_ARG, "below 0");
    REFUSED(fc_channel_add_resequence(ctx, "c", INT64_MIN), FC_E_ARG, "below 0");
    REFUSED(fc_channel_add_delay(ctx, "c", INT64_MIN), FC_E_ARG, "below 0");
    REFUSED(fc_channel_add_delay_time(ctx, "c", INT64_MIN), FC_E_ARG, "below 0");
    REFUSED(fc_trigger_time(ctx, fault, INT64_MIN, 1), FC_E_ARG, "below 0");
    REFUSED(fc_trigger_periodic(ctx, fault, 0, 1), FC_E_ARG, "period");
}

/* Faults and their triggers by numbers that are no faults. */
static void faults_there_are_not(void) {
    start();
    const fc_fault_id gone = fc_add_offset(ctx, "p", 1);
    fc_remove(ctx, gone);
    const fc_fault_id none[] = {0, -1, gone, gone + 1, INT64_MAX, INT64_MIN, FC_E_ARG};
    for (size_t at = 0; at < sizeof none / sizeof *none; ++at) {
        REFUSED(fc_trigger_after(ctx, none[at], 1), FC_E_NO_FAULT, "no fault");
        REFUSED(fc_trigger_once_after(ctx, none[at], 1), FC_E_NO_FAULT, "no fault");
        REFUSED(fc_trigger_duration(ctx, none[at], 1), FC_E_NO_FAULT, "no fault");
        REFUSED(fc_trigger_time(ctx, none[at], 1, 1), FC_E_NO_FAULT, "no fault");
        REFUSED(fc_trigger_random(ctx, none[at], 1), FC_E_NO_FAULT, "no fault");
        REFUSED(fc_trigger_periodic(ctx, none[at], 1, 1), FC_E_NO_FAULT, "no fault");
        REFUSED(fc_trigger_none(ctx, none[at]), FC_E_NO_FAULT, "no fault");
        REFUSED(fc_enable(ctx, none[at], false), FC_E_NO_FAULT, "no fault");
        REFUSED(fc_remove(ctx, none[at]), FC_E_NO_FAULT, "no fault");
        REFUSED(fc_channel_fault_receiver(ctx, none[at], "r"), FC_E_NO_FAULT, "no fault");
    }
    REFUSED(fc_latest(ctx, "p"), FC_E_NO_FAULT, "p");
    REFUSED(fc_channel_latest(ctx, "c"), FC_E_NO_FAULT, "c");
}

static int get_into(char *data, size_t capacity, size_t *len) {
    return fc_channel_get(ctx, "c", "", data, capacity, len);
}

/* Limits that are allowed: nothing overflows. */
static void huge_counts(void) {
    char data[16];
    size_t len = 0;
    start();
    fc_channel_put(ctx, "c", "abc", 3);
    for (int fault = 0; fault < 3; ++fault)
        CHECK(fc_channel_add_repeat(ctx, "c", INT64_MAX) > 0);
    CHECK_INT(get_into(data, sizeof data, &len), 1);
    CHECK_INT(fc_channel_depth(ctx, "c", ""), INT64_MAX);
    CHECK_INT(get_into(data, sizeof data, &len), 1);
    CHECK_INT(fc_channel_depth(ctx, "c", ""), INT64_MAX - 1);
    CHECK(fc_channel_add_drop(ctx, "c", INT64_MAX) > 0);
    CHECK_INT(get_into(data, sizeof data, &len), 0);
    CHECK_INT(fc_channel_depth(ctx, "c", ""), 0);

    start();
    fc_channel_put(ctx, "c", "abc", 3);
    CHECK(fc_channel_add_resequence(ctx, "c", INT64_MAX) > 0);
    CHECK(fc_channel_add_truncate(ctx, "c", SIZE_MAX / 2) > 0);
    REFUSED(fc_channel_add_truncate(ctx, "c", SIZE_MAX / 2 + 1), FC_E_ARG, "2^63");
    REFUSED(fc_channel_add_extend(ctx, "c", SIZE_MAX, 'x'), FC_E_ARG, "2^63");
    CHECK_INT(get_into(data, sizeof data, &len), 1);
    CHECK_INT(len, 3);
    fc_channel_put(ctx, "c", "abc", 3);
    fc_channel_add_extend(ctx, "c", SIZE_MAX / 2, 'x');
    CHECK_INT(get_into(data, sizeof data, &len), FC_E_NOMEM);
    CHECK_ERROR(FC_E_NOMEM, "memory");
    CHECK_INT(fc_channel_depth(ctx, "c", ""), 1);

    start();
    fc_channel_add_delay(ctx, "c", INT64_MAX);
    fc_channel_add_delay_time(ctx, "c", INT64_MAX);
    CHECK_INT(fc_channel_put(ctx, "c", "abc", 3), FC_OK);
    CHECK_INT(get_into(data, sizeof data, &len), 0);
    const fc_fault_id fault = fc_add_offset(ctx, "p", 1);
    int32_t value = 0;
    fc_trigger_after(ctx, fault, UINT64_MAX);
    fc_trigger_duration(ctx, fault, INT64_MIN);
    fc_trigger_time(ctx, fault, INT64_MAX, INT64_MAX);
    fc_trigger_periodic(ctx, fault, UINT64_MAX, UINT64_MAX);
    CHECK_INT(fc_probe_i32(ctx, "p", &value), FC_OK);
    CHECK_INT(value, 0);
    CHECK_NO_ERROR();
}

static void fields_outside_the_packet(void) {
    const fc_model flip = {FC_BITFLIP, 0, 0, 0};
    const size_t offsets[] = {2, 3, 4, SIZE_MAX, SIZE_MAX - 1, SIZE_MAX / 2};
    for (size_t at = 0; at < sizeof offsets / sizeof *offsets; ++at) {
        char data[8] = "";
        size_t len = 0;
        start();
        const fc_field word = {offsets[at], FC_U16, false, 0};
        const fc_field bytes = {offsets[at], FC_BYTES, false, 2};
        fc_channel_add_field(ctx, "c", &word, &flip);
        fc_channel_put(ctx, "c", "abc", 3);
        CHECK_INT(get_into(data, sizeof data, &len), 1);
        CHECK_ERROR(FC_E_INDEX, "3 bytes");
        fc_channel_remove_faults(ctx, "c");
        fc_channel_add_field(ctx, "c", &bytes, &flip);
        fc_channel_put(ctx, "c", "abc", 3);
        CHECK_INT(get_into(data, sizeof data, &len), 1);
        CHECK_ERROR(FC_E_INDEX, "3 bytes");
        CHECK_INT(len, 3);
        CHECK(memcmp(data, "abc", 3) == 0);
    }
    start();
    const fc_field no_length = {1, FC_BYTES, false, SIZE_MAX};
    char data[8];
    fc_channel_add_field(ctx, "c", &no_length, &flip);
    fc_channel_add_corruption(ctx, "c", INT_MAX, 7);
    fc_channel_put(ctx, "c", "abc", 3);
    CHECK_INT(get_into(data, sizeof data, NULL), 1);
    CHECK_INT(errors_seen, 2);
    CHECK_INT(errors_code, FC_E_INDEX);
}

/* A name is its bytes: each single byte, 0 ending it, is another one. */
static void names_of_any_bytes(void) {
    start();
    for (int byte = 1; byte < 256; ++byte) {
        const char id[] = {(char)byte, '\0'};
        CHECK(fc_add_offset(ctx, id, byte) > 0);
        CHECK_INT(fc_channel_put(ctx, id, id, 1), FC_OK);
        CHECK_INT(fc_channel_subscribe(ctx, "receivers", id), FC_OK);
    }
    CHECK_INT(fc_channel_put(ctx, "receivers", "x", 1), FC_OK);
    for (int byte = 1; byte < 256; ++byte) {
        const char id[] = {(char)byte, '\0'};
        int32_t value = 0;
        char packet = 0;
        CHECK_INT(fc_probe_i32(ctx, id, &value), FC_OK);
        CHECK_INT(value, byte);
        CHECK_INT(fc_channel_get(ctx, id, "", &packet, 1, NULL), 1);
        CHECK_INT((unsigned char)packet, byte);
        CHECK_INT(fc_channel_get(ctx, "receivers", id, &packet, 1, NULL), 1);
    }
    CHECK_NO_ERROR();
}

static void a_name_of_a_million_bytes(void) {
    start();
    const size_t length = 1000000;
    char *id = malloc(length + 1);
    memset(id, 0xfe, length);
    id[length] = '\0';
    int32_t value = 0;
    CHECK_INT(fc_record_start(ctx, NULL), FC_OK);
    CHECK(fc_add_offset(ctx, id, 7) > 0);
    CHECK_INT(fc_probe_i32(ctx, id, &value), FC_OK);
    CHECK_INT(value, 7);
    CHECK_INT(fc_list(ctx, ignore_listed, NULL), FC_OK);
    CHECK_INT(fc_record_stop(ctx), FC_OK);
    CHECK(fc_record_copy(ctx, NULL, 0) > length);
    CHECK_NO_ERROR();
    id[length - 1] = 1;
    CHECK_INT(fc_latest(ctx, id), FC_E_NO_FAULT);
    CHECK(strlen(fc_last_error_text()) < 300);
    free(id);
}

int main(void) {
    each_code();
    every_code_has_a_name();
    null_values();
    null_parameters();
    null_recordings();
    null_that_is_meant();
    numbers_that_are_none();
    numbers_out_of_range();
    faults_there_are_not();
    huge_counts();
    fields_outside_the_packet();
    names_of_any_bytes();
    a_name_of_a_million_bytes();
    fc_free(ctx);
    return CHECK_RESULT();
}
