/* Contexts, seeds and their streams, fault ids, receivers (7.1, 7.3, 7.7 of the reference). */
#define _POSIX_C_SOURCE 200809L
#include "errors.h"
#include "faultcheck_wrapper.h"

#include <stdlib.h>

static int32_t probe(fc_context *ctx, const char *id, int32_t value) {
    fc_probe_i32(ctx, id, &value);
    return value;
}

static void contexts_do_not_influence_each_other(void) {
    fc_context *a = fc_new(NULL), *b = fc_new(NULL);
    fc_add_offset(a, "p", 1);
    CHECK_INT(probe(a, "p", 0), 1);
    CHECK_INT(probe(b, "p", 0), 0);
    CHECK_INT(probe(NULL, "p", 0), 0);
    fc_channel_put(a, "c", "x", 1);
    CHECK_INT(fc_channel_depth(a, "c", NULL), 1);
    CHECK_INT(fc_channel_depth(b, "c", NULL), 0);
    fc_free(a);
    fc_free(b);
    fc_free(NULL);
}

static void the_default_context_stays(void) {
    CHECK(fc_default() != NULL);
    CHECK(faultcheck_instance() == (void *)fc_default());
    errors_start(NULL);
    fc_free(fc_default());
    CHECK_ERROR(FC_E_ARG, "fc_reset");
    fc_add_offset(fc_default(), "p", 1);
    CHECK_INT(probe(NULL, "p", 0), 1);
    faultcheck_removeAllFaults();
    CHECK_INT(probe(NULL, "p", 0), 0);
}

static void options_are_checked(void) {
    fc_options options = FC_OPTIONS_INIT;
    options.size = 3;
    errors_start(NULL);
    CHECK(fc_new(&options) == NULL);
    CHECK_ERROR(FC_E_ARG, "FC_OPTIONS_INIT");
}

static void reset_is_the_state_after_new(void) {
    fc_context *ctx = fc_new(NULL);
    errors_start(ctx);
    int32_t first = 0, second = 0;
    for (int round = 0; round < 2; round++) {
        CHECK_INT(fc_add_bitflip_random(ctx, "p"), 1);
        CHECK_INT(fc_channel_add_drop(ctx, "c", 1), 2);
        fc_channel_put(ctx, "c", "x", 1);
        fc_channel_subscribe(ctx, "c", "r");
        fc_add_bitflip(ctx, "p", -1);
        CHECK_INT(fc_error_count(ctx), 1);
        *(round == 0 ? &first : &second) = probe(ctx, "p", 0);
        fc_seed(ctx, 99);
        fc_reset(ctx);
        CHECK_INT(fc_error_count(ctx), 0);
        CHECK_INT(fc_channel_depth(ctx, "c", ""), 0);
        CHECK_INT(fc_channel_depth(ctx, "c", "r"), 0);
        CHECK_INT(probe(ctx, "p", 0), 0);
        CHECK_INT(fc_num_active(ctx, "p"), 0);
    }
    CHECK_INT(first, second);
    fc_free(ctx);
}

/* Expected flips computed by an independent Python program from 7.3: SplitMix64 started at
 * seed ^ FNV-1a-64(identifier) ^ ordinal * 0x9E3779B97F4A7C15, integers below n by multiply-high.
 */
static void streams_follow_the_reference(void) {
    fc_context *ctx = fc_new(NULL);
    fc_fault_id first = fc_add_bitflip_random(ctx, "S1val");
    const int expected[6] = {2, 2, 15, 14, 21, 6};
    for (int at = 0; at < 6; at++)
        CHECK_INT(probe(ctx, "S1val", 0), (int32_t)(1u << expected[at]));
    fc_remove(ctx, first);
    fc_add_bitflip_random(ctx, "S1val"); /* ordinal 1, also after a removal */
    const int later[6] = {3, 27, 10, 5, 25, 9};
    for (int at = 0; at < 6; at++)
        CHECK_INT(probe(ctx, "S1val", 0), (int32_t)(1u << later[at]));
    fc_seed(ctx, 12345);
    const int seeded[6] = {51, 8, 9, 62, 28, 1};
    for (int at = 0; at < 6; at++) {
        double value = 0;
        uint64_t bits;
        fc_probe_f64(ctx, "S1val", &value);
        memcpy(&bits, &value, 8);
        CHECK(bits == UINT64_C(1) << seeded[at]);
    }
    fc_free(ctx);
}

/* Expected flips from the same program; the stream starts at seed ^ FNV-1a-64 of nothing. */
static void a_fault_may_have_a_seed_of_its_own(void) {
    const int expected[6] = {2, 27, 22, 12, 21, 26};
    fc_context *ctx = fc_new(NULL);
    errors_start(ctx);
    fc_add_bitflip_random(ctx, "p");
    fc_remove_probe_faults(ctx, "p");
    for (int at = 0; at < 2; at++) {
        const char *id = at == 0 ? "p" : "q";
        CHECK_INT(fc_seed_fault(ctx, fc_add_bitflip_random(ctx, id), 4711), FC_OK);
        for (int call = 0; call < 6; call++)
            CHECK_INT(probe(ctx, id, 0), (int32_t)(1u << expected[call]));
    }
    CHECK_NO_ERROR();
    CHECK_INT(fc_seed_fault(ctx, 99, 1), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "99");
    fc_free(ctx);
}

static void a_stream_advances_on_affected_calls_only(void) {
    fc_context *a = fc_new(NULL), *b = fc_new(NULL);
    fc_trigger_after(a, fc_add_bitflip_random(a, "p"), 7);
    fc_add_bitflip_random(b, "p");
    fc_add_bitflip_random(b, "q");
    for (int at = 0; at < 7; at++)
        CHECK_INT(probe(a, "p", 0), 0);
    for (int at = 0; at < 20; at++) {
        probe(b, "q", 0);
        CHECK_INT(probe(a, "p", 0), probe(b, "p", 0));
    }
    fc_free(a);
    fc_free(b);
}

static void triggers_take_any_fault_by_id(void) {
    fc_context *ctx = fc_new(NULL);
    errors_start(ctx);
    fc_fault_id one = fc_add_offset(ctx, "p", 1), ten = fc_add_offset(ctx, "p", 10);
    CHECK(one > 0 && ten > one);
    CHECK_INT(fc_latest(ctx, "p"), ten);
    CHECK_INT(fc_trigger_after(ctx, one, 1), FC_OK);
    CHECK_INT(probe(ctx, "p", 0), 10);
    CHECK_INT(probe(ctx, "p", 0), 11);
    CHECK_INT(fc_trigger_once_after(ctx, ten, 1), FC_OK);
    CHECK_INT(probe(ctx, "p", 0), 1);
    CHECK_INT(probe(ctx, "p", 0), 11);
    CHECK_INT(probe(ctx, "p", 0), 1);
    CHECK_INT(fc_trigger_duration(ctx, ten, -5), FC_OK);
    CHECK_INT(probe(ctx, "p", 0), 11);
    CHECK_INT(fc_remove(ctx, one), FC_OK);
    CHECK_INT(probe(ctx, "p", 0), 10);
    CHECK_INT(fc_remove(ctx, ten), FC_OK);
    CHECK_INT(probe(ctx, "p", 0), 0);
    CHECK_NO_ERROR();
    CHECK_INT(fc_remove(ctx, ten), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "no fault 2");
    CHECK_INT(fc_trigger_after(ctx, ten, 1), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "no fault 2");
    CHECK_INT(fc_latest(ctx, "p"), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "\"p\"");
    CHECK_INT(fc_channel_latest(ctx, "p"), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "channel \"p\"");
    fc_free(ctx);
}

static char take(fc_context *ctx, const char *receiver) {
    char data[4];
    size_t len;
    return fc_channel_get(ctx, "c", receiver, data, sizeof data, &len) == 1 ? data[0] : '-';
}

static void each_receiver_has_its_own_queue_and_triggers(void) {
    fc_context *ctx = fc_new(NULL);
    errors_start(ctx);
    fc_channel_put(ctx, "c", "0", 1);
    fc_channel_subscribe(ctx, "c", "a");
    fc_trigger_once_after(ctx, fc_channel_add_corruption(ctx, "c", 0, 1), 1);
    fc_channel_subscribe(ctx, "c", "b");
    fc_channel_subscribe(ctx, "c", "b");
    fc_channel_put(ctx, "c", "@", 1);
    fc_channel_put(ctx, "c", "@", 1);
    CHECK_INT(fc_channel_depth(ctx, "c", "a"), 2);
    CHECK_INT(fc_channel_depth(ctx, "c", "b"), 2);
    CHECK_INT(fc_channel_depth(ctx, "c", ""), 1);
    CHECK_INT(take(ctx, "a"), '@');
    CHECK_INT(take(ctx, "a"), 'B');
    CHECK_INT(take(ctx, "a"), '-');
    CHECK_INT(take(ctx, "b"), '@');
    CHECK_INT(take(ctx, "b"), 'B');
    CHECK_INT(take(ctx, ""), '0');
    CHECK_NO_ERROR();
    CHECK_INT(fc_channel_get(ctx, "c", "z", NULL, 0, NULL), FC_E_RECEIVER);
    CHECK_ERROR(FC_E_RECEIVER, "\"c\"");
    CHECK_INT(fc_channel_depth(ctx, "c", "z"), FC_E_RECEIVER);
    CHECK_ERROR(FC_E_RECEIVER, "\"c\"");
    fc_channel_clear(ctx, "c");
    fc_channel_clear(ctx, "unknown");
    CHECK_INT(take(ctx, "a"), '-');
    CHECK_INT(fc_channel_get(ctx, "unknown", "z", NULL, 0, NULL), 0);
    CHECK_INT(fc_channel_get(ctx, "c", "a", NULL, 5, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "NULL");
    CHECK_INT(fc_channel_put(ctx, "c", NULL, 5), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "NULL");
    fc_free(ctx);
}

static void errors_can_be_cleared_and_named(void) {
    errors_start(NULL);
    fc_remove(NULL, 77);
    CHECK_INT(fc_last_error(), FC_E_NO_FAULT);
    fc_clear_last_error();
    CHECK_INT(fc_last_error(), FC_OK);
    CHECK(strcmp(fc_last_error_text(), "") == 0);
    const char *names[] = {"FC_OK",      "FC_E_ARG",     "FC_E_NOMEM", "FC_E_BIT",
                           "FC_E_INDEX", "FC_E_VALUE",   "FC_E_TYPE",  "FC_E_NO_FAULT",
                           "FC_E_SPACE", "FC_E_RECEIVER"};
    for (int at = 0; at < 10; at++)
        CHECK(strcmp(fc_error_name(-at), names[at]) == 0);
    CHECK(strcmp(fc_error_name(5), "FC_E_UNKNOWN") == 0);
}

static void strange_identifiers_make_readable_messages(void) {
    char id[200];
    memset(id, 'x', sizeof id);
    id[199] = '\0';
    errors_start(NULL);
    fc_add_bitflip(NULL, "a\n\"\\\x7f", -1);
    CHECK_ERROR(FC_E_BIT, "probe \"a\\x0a\\\"\\\\\\x7f\"");
    fc_add_bitflip(NULL, id, -1);
    CHECK_ERROR(FC_E_BIT, "xxxx...\"");
    memset(id, 1, 199);
    fc_add_bitflip(NULL, id, -1);
    CHECK_ERROR(FC_E_BIT, "\\x01...\"");
}

int main(void) {
    contexts_do_not_influence_each_other();
    the_default_context_stays();
    options_are_checked();
    reset_is_the_state_after_new();
    streams_follow_the_reference();
    a_fault_may_have_a_seed_of_its_own();
    a_stream_advances_on_affected_calls_only();
    triggers_take_any_fault_by_id();
    each_receiver_has_its_own_queue_and_triggers();
    errors_can_be_cleared_and_named();
    strange_identifiers_make_readable_messages();
    return CHECK_RESULT();
}
