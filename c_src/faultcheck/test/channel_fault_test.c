/* The communication faults (7.7 of the reference), each alone and where order matters together. */
#include "errors.h"

static fc_context *ctx;

static void start(const char *packets) {
    fc_reset(ctx);
    errors_start(ctx);
    for (; *packets != '\0'; packets++)
        CHECK_INT(fc_channel_put(ctx, "c", packets, 1), FC_OK);
}

/* What `gets` gets of a receiver deliver, '-' for nothing; packets of more than one byte in
 * brackets. */
static const char *take(const char *receiver, int gets) {
    static char got[200];
    size_t at = 0;
    for (; gets > 0; gets--) {
        char data[32] = "";
        size_t len = 0;
        const int result = fc_channel_get(ctx, "c", receiver, data, sizeof data - 1, &len);
        if (result != 1)
            at += (size_t)sprintf(got + at, result == 0 ? "-" : "?");
        else
            at += (size_t)sprintf(got + at, len == 1 ? "%s" : "[%s]", data);
    }
    got[at] = '\0';
    return got;
}

#define CHECK_TAKE(receiver, gets, expected)                                                       \
    do {                                                                                           \
        const char *check_took = take(receiver, gets);                                             \
        if (strcmp(check_took, expected) != 0) {                                                   \
            check_failures++;                                                                      \
            fprintf(stderr, "%s:%d: got %s, expected %s\n", __FILE__, __LINE__, check_took,        \
                    expected);                                                                     \
        }                                                                                          \
    } while (0)

static void lose_discards_one_packet_per_get(void) {
    start("ABCDE");
    CHECK(fc_channel_add_lose(ctx, "c") > 0);
    CHECK_TAKE("", 4, "BD--");
}

static void repeat_last_delivers_again_while_the_head_stays(void) {
    start("ABC");
    fc_fault_id fault = fc_channel_add_repeat_last(ctx, "c");
    fc_trigger_after(ctx, fault, 1);
    fc_trigger_duration(ctx, fault, 2);
    CHECK_TAKE("", 5, "AAABC");
    fc_trigger_duration(ctx, fault, 1);
    CHECK_TAKE("", 2, "C-"); /* also on an empty channel */
    start("AB");
    fc_channel_add_repeat_last(ctx, "c"); /* nothing was delivered before: no effect at first */
    CHECK_TAKE("", 3, "AAA");
}

static void the_last_packet_is_known_without_faults_too(void) {
    start("AB");
    CHECK_TAKE("", 1, "A");
    fc_trigger_duration(ctx, fc_channel_add_repeat_last(ctx, "c"), 1);
    CHECK_TAKE("", 3, "AB-");
}

static void insert_adds_foreign_packets(void) {
    start("A");
    CHECK(fc_channel_add_insert(ctx, "c", "xyz", 3, 2) > 0);
    CHECK_TAKE("", 4, "[xyz][xyz]A-");
    start("");
    fc_channel_add_insert(ctx, "c", NULL, 0, 1);
    CHECK_TAKE("", 2, "[]-");
    CHECK_INT(fc_channel_add_insert(ctx, "c", NULL, 1, 1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "NULL");
    CHECK_INT(fc_channel_add_insert(ctx, "c", "a", 1, -1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "below 0");
}

static void masquerade_takes_from_another_channel(void) {
    char data[4];
    size_t len;
    start("AB");
    fc_channel_put(ctx, "other", "x", 1);
    fc_channel_add_masquerade(ctx, "c", "other");
    CHECK_TAKE("", 3, "xAB");
    CHECK_INT(fc_channel_get(ctx, "other", "", data, 4, &len), 0);
    start("AB");
    fc_channel_add_masquerade(ctx, "c", "unknown");
    CHECK_TAKE("", 2, "AB");
    start("AB");
    fc_channel_add_masquerade(ctx, "c", "c"); /* its own head again */
    CHECK_TAKE("", 3, "BA-");
}

static void a_small_buffer_leaves_both_channels(void) {
    char data[4];
    size_t len;
    start("A");
    fc_channel_put(ctx, "other", "xyz", 3);
    fc_channel_add_masquerade(ctx, "c", "other");
    CHECK_INT(fc_channel_get(ctx, "c", "", data, 2, &len), FC_E_SPACE);
    CHECK_INT(len, 3);
    CHECK_INT(fc_channel_depth(ctx, "other", ""), 1);
    CHECK_INT(fc_channel_depth(ctx, "c", ""), 1);
    CHECK_TAKE("", 3, "[xyz]A-");
}

static void resequence_delivers_a_later_packet(void) {
    start("ABCD");
    fc_fault_id fault = fc_channel_add_resequence(ctx, "c", 2);
    fc_trigger_once_after(ctx, fault, 0);
    CHECK_TAKE("", 5, "CABD-");
    start("AB");
    fc_channel_add_resequence(ctx, "c", 9);
    CHECK_TAKE("", 3, "BA-");
    start("AB");
    fc_channel_add_resequence(ctx, "c", 0);
    CHECK_TAKE("", 3, "AB-");
    CHECK_INT(fc_channel_add_resequence(ctx, "c", -1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "position");
}

static void block_delivers_nothing_and_keeps_the_queue(void) {
    start("AB");
    fc_trigger_duration(ctx, fc_channel_add_block_get(ctx, "c"), 2);
    fc_channel_add_insert(ctx, "c", "x", 1, 1); /* not through the block */
    CHECK_TAKE("", 5, "--xAB");
}

static void truncate_and_extend(void) {
    start("");
    fc_channel_put(ctx, "c", "ABCDEF", 6);
    fc_channel_put(ctx, "c", "G", 1);
    fc_channel_add_truncate(ctx, "c", 3);
    fc_channel_add_extend(ctx, "c", 2, '!');
    CHECK_TAKE("", 2, "[ABC!!][G!!]");
    CHECK_INT(fc_channel_add_truncate(ctx, "c", SIZE_MAX), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "length");
    CHECK_INT(fc_channel_add_extend(ctx, "c", SIZE_MAX, 0), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "length");
    start("");
    fc_channel_add_extend(ctx, "c", SIZE_MAX / 4, 'x');
    fc_channel_put(ctx, "c", "A", 1);
    char data[4];
    CHECK_INT(fc_channel_get(ctx, "c", "", data, 4, NULL), FC_E_NOMEM);
    CHECK_ERROR(FC_E_NOMEM, "memory");
    CHECK_INT(fc_channel_put(ctx, "c", "A", SIZE_MAX), FC_E_NOMEM);
    CHECK_ERROR(FC_E_NOMEM, "memory");
    CHECK_INT(fc_channel_depth(ctx, "c", ""), 1);
}

static void chosen_packets_pass_the_faults_that_follow(void) {
    start("@");
    fc_channel_add_corruption(ctx, "c", 0, 0); /* goes with the head when another is chosen */
    fc_channel_add_insert(ctx, "c", "P", 1, 1);
    fc_channel_add_corruption(ctx, "c", 0, 1);
    fc_trigger_duration(ctx, fc_channel_add_repeat(ctx, "c", 1), 1);
    CHECK_TAKE("", 3, "RSC"); /* P^2; the clean P repeated: P^3; then the head: @^3 */
}

static void fields_are_altered_by_any_model(void) {
    const fc_model plus_1 = {FC_OFFSET, 1, 0, 0}, noise = {FC_NOISE_GAUSS, 1, 0, 0};
    const fc_model flip = {FC_BITFLIP, 0, 0, 9};
    const fc_field big = {1, FC_U16, true, 0}, little = {1, FC_U16, false, 0};
    const fc_field bytes = {1, FC_BYTES, false, 2}, truth = {0, FC_BOOL, false, 0};
    char data[4];
    size_t len;
    start("");
    fc_channel_add_field(ctx, "c", &big, &plus_1);
    fc_channel_put(ctx, "c", "\x00\x01\xff", 3);
    CHECK_INT(fc_channel_get(ctx, "c", "", data, 4, &len), 1);
    CHECK(len == 3 && memcmp(data, "\x00\x02\x00", 3) == 0);
    start("");
    fc_channel_add_field(ctx, "c", &little, &plus_1);
    fc_channel_put(ctx, "c", "\x00\xff\x01", 3);
    CHECK_INT(fc_channel_get(ctx, "c", "", data, 4, &len), 1);
    CHECK(memcmp(data, "\x00\x00\x02", 3) == 0);
    fc_channel_put(ctx, "c", "\x00\xff", 2);
    CHECK_NO_ERROR();
    CHECK_INT(fc_channel_get(ctx, "c", "", data, 4, &len), 1);
    CHECK_ERROR(FC_E_INDEX, "field at byte 1");
    CHECK(len == 2 && memcmp(data, "\x00\xff", 2) == 0);
    start("");
    fc_channel_add_field(ctx, "c", &bytes, &flip);
    fc_channel_put(ctx, "c", "\x00\x00\x00\x00", 4);
    CHECK_INT(fc_channel_get(ctx, "c", "", data, 4, &len), 1);
    CHECK(memcmp(data, "\x00\x00\x02\x00", 4) == 0);
    start("");
    fc_channel_add_field(ctx, "c", &truth, &plus_1);
    fc_channel_put(ctx, "c", "\x07", 1); /* any byte but 0 is true */
    CHECK_INT(fc_channel_get(ctx, "c", "", data, 4, &len), 1);
    CHECK_INT(data[0], 1);
    start("");
    fc_channel_add_field(ctx, "c", &bytes, &noise);
    fc_channel_put(ctx, "c", "abcd", 4);
    CHECK_INT(fc_channel_get(ctx, "c", "", data, 4, &len), 1);
    CHECK_ERROR(FC_E_TYPE, "does not apply");
}

static void a_field_of_every_type(void) {
    const int sizes[] = {4, 8, 1, 2, 4, 8, 1, 2, 4, 8, 1};
    const fc_model zero = {FC_SET_TO, 0, 0, 0};
    for (int type = FC_F32; type <= FC_BOOL; type++) {
        char data[16];
        size_t len;
        const fc_field field = {1, (fc_type)type, type % 2 == 0, 0};
        start("");
        CHECK(fc_channel_add_field(ctx, "c", &field, &zero) > 0);
        fc_channel_put(ctx, "c", "\1\1\1\1\1\1\1\1\1\1\1\1", 12);
        CHECK_INT(fc_channel_get(ctx, "c", "", data, 16, &len), 1);
        for (int at = 0; at < 12; at++)
            CHECK_INT(data[at], at >= 1 && at <= sizes[type] ? 0 : 1);
    }
}

static void fields_are_checked(void) {
    const fc_model good = {FC_OFFSET, 1, 0, 0}, bad = {FC_RAMP, 1, 0, 0};
    const fc_field field = {0, FC_U8, false, 0};
    start("");
    CHECK_INT(fc_channel_add_field(ctx, "c", NULL, &good), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "field");
    CHECK_INT(fc_channel_add_field(ctx, "c", &field, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "model");
    CHECK_INT(fc_channel_add_field(ctx, "c", &field, &bad), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "calls");
}

static void delay_by_gets_keeps_the_order(void) {
    start("");
    fc_fault_id fault = fc_channel_add_delay(ctx, "c", 2);
    fc_channel_put(ctx, "c", "A", 1);
    fc_remove(ctx, fault);
    fc_channel_put(ctx, "c", "B", 1); /* waits behind the hidden head */
    CHECK_INT(fc_channel_depth(ctx, "c", ""), 2);
    CHECK_TAKE("", 5, "--AB-");
    start("");
    fc_channel_add_delay(ctx, "c", 0);
    fc_channel_put(ctx, "c", "A", 1);
    CHECK_TAKE("", 1, "A");
    CHECK_INT(fc_channel_add_delay(ctx, "c", -1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "gets");
}

static void hidden_packets_cannot_be_dropped(void) {
    start("A");
    fc_trigger_once_after(ctx, fc_channel_add_delay(ctx, "c", 2), 0);
    fc_channel_put(ctx, "c", "B", 1);
    fc_channel_put(ctx, "c", "C", 1);
    fc_channel_add_drop(ctx, "c", 2);
    CHECK_TAKE("", 4, "--C-"); /* A dropped; B hidden for another get, then dropped */
}

static void delay_by_time(void) {
    start("");
    fc_advance(ctx, 1000);
    fc_channel_add_delay_time(ctx, "c", 500);
    fc_channel_put(ctx, "c", "A", 1);
    CHECK_TAKE("", 2, "--");
    fc_channel_remove_faults(ctx, "c"); /* the packet stays delayed */
    fc_advance(ctx, 499);
    CHECK_TAKE("", 1, "-");
    fc_advance(ctx, 1);
    CHECK_TAKE("", 2, "A-");
    fc_channel_add_delay_time(ctx, "c", INT64_MAX); /* does not overflow */
    fc_channel_put(ctx, "c", "B", 1);
    CHECK_TAKE("", 1, "-");
    CHECK_INT(fc_channel_add_delay_time(ctx, "c", -1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "time");
}

static void misroute_sends_to_another_channel(void) {
    char data[4];
    size_t len;
    start("");
    fc_trigger_once_after(ctx, fc_channel_add_misroute(ctx, "c", "other"), 1);
    fc_channel_put(ctx, "c", "A", 1);
    fc_channel_put(ctx, "c", "B", 1);
    fc_channel_put(ctx, "c", "C", 1);
    CHECK_TAKE("", 3, "AC-");
    CHECK_INT(fc_channel_get(ctx, "other", "", data, 4, &len), 1);
    CHECK_INT(data[0], 'B');
}

static void block_refuses_the_put(void) {
    start("");
    fc_trigger_once_after(ctx, fc_channel_add_block_put(ctx, "c"), 0);
    CHECK_INT(fc_channel_put(ctx, "c", "A", 1), FC_E_BLOCKED);
    CHECK_ERROR(FC_E_BLOCKED, "\"c\"");
    CHECK_INT(fc_channel_put(ctx, "c", "B", 1), FC_OK);
    CHECK_TAKE("", 2, "B-");
}

static void subscribe_three(void) {
    start("");
    fc_channel_subscribe(ctx, "c", "a");
    fc_channel_subscribe(ctx, "c", "b");
    fc_channel_subscribe(ctx, "c", "d");
}

static void subset_reaches_the_listed_receivers_only(void) {
    const char *listed[] = {"a", "d", "nobody"};
    subscribe_three();
    CHECK(fc_channel_add_subset(ctx, "c", listed, 3) > 0);
    fc_channel_put(ctx, "c", "A", 1);
    CHECK_TAKE("a", 2, "A-");
    CHECK_TAKE("b", 1, "-");
    CHECK_TAKE("d", 2, "A-");
    CHECK_INT(fc_channel_add_subset(ctx, "c", NULL, 3), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "receivers");
    fc_reset(ctx);
    fc_channel_add_subset(ctx, "c", listed, 0);
    fc_channel_put(ctx, "c", "A", 1);
    CHECK_TAKE("", 1, "-");
}

static void asymmetric_alters_the_listed_receivers_copy(void) {
    const char *listed[] = {"b", "d"};
    const fc_model flip = {FC_BITFLIP, 0, 0, 1}, plus = {FC_OFFSET, 5, 0, 0};
    const fc_field field = {0, FC_U8, false, 0}, far = {7, FC_U8, false, 0};
    subscribe_three();
    CHECK(fc_channel_add_asymmetric(ctx, "c", listed, 2, NULL, &flip) > 0);
    CHECK(fc_channel_add_asymmetric(ctx, "c", listed, 1, &field, &plus) > 0);
    fc_channel_put(ctx, "c", "@", 1);
    CHECK_NO_ERROR();
    CHECK_TAKE("a", 1, "@");
    CHECK_TAKE("b", 1, "G");
    CHECK_TAKE("d", 1, "B");
    subscribe_three();
    fc_channel_add_asymmetric(ctx, "c", listed, 2, &far, &plus);
    CHECK_INT(fc_channel_put(ctx, "c", "@", 1), FC_OK);
    CHECK_ERROR(FC_E_INDEX, "byte 7");
    CHECK_TAKE("b", 1, "@");
    CHECK_INT(fc_channel_add_asymmetric(ctx, "c", NULL, 2, NULL, &flip), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "receivers");
    CHECK_INT(fc_channel_add_asymmetric(ctx, "c", listed, 2, NULL, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "model");
}

static void a_fault_can_be_for_one_receiver(void) {
    subscribe_three();
    fc_fault_id fault = fc_channel_add_corruption(ctx, "c", 0, 1);
    CHECK_INT(fc_channel_fault_receiver(ctx, fault, "b"), FC_OK);
    fc_channel_put(ctx, "c", "@", 1);
    CHECK_TAKE("a", 1, "@");
    CHECK_TAKE("b", 1, "B");
    CHECK_TAKE("d", 1, "@");
    CHECK_INT(fc_channel_fault_receiver(ctx, 99, "b"), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "99");
    fault = fc_channel_add_block_put(ctx, "c");
    CHECK_INT(fc_channel_fault_receiver(ctx, fault, "b"), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "gets");
    fault = fc_add_offset(ctx, "p", 1);
    CHECK_INT(fc_channel_fault_receiver(ctx, fault, "b"), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "gets");
}

static bool gate;
static bool is_open(void *user) {
    (void)user;
    return gate;
}

static void channels_know_every_trigger(void) {
    start("@@@@");
    fc_fault_id fault = fc_channel_add_corruption(ctx, "c", 0, 1);
    fc_trigger_when(ctx, fault, is_open, NULL);
    gate = false;
    CHECK_TAKE("", 1, "@");
    gate = true;
    CHECK_TAKE("", 1, "B");
    fc_trigger_none(ctx, fault);
    fc_trigger_time(ctx, fault, 10, -1);
    CHECK_TAKE("", 1, "@");
    fc_advance(ctx, 10);
    CHECK_TAKE("", 1, "B");
}

static void delays_hold_on_the_channels_that_packets_get_to(void) {
    start("");
    fc_advance(ctx, 1000);
    CHECK_INT(fc_channel_put(ctx, "c", "A", 1), FC_OK);
    CHECK_TAKE("", 1, "A");
    fc_channel_add_misroute(ctx, "other", "c");
    fc_channel_add_delay(ctx, "other", 1);
    CHECK_INT(fc_channel_put(ctx, "other", "B", 1), FC_OK);
    CHECK_TAKE("", 2, "-B"); /* one get after those that were before */

    start("");
    fc_advance(ctx, 1000);
    fc_channel_add_misroute(ctx, "other", "c");
    fc_channel_add_delay_time(ctx, "other", 500);
    CHECK_INT(fc_channel_put(ctx, "other", "A", 1), FC_OK);
    CHECK_TAKE("", 1, "-");
    fc_advance(ctx, 500);
    CHECK_TAKE("", 1, "A");

    start("");
    fc_advance(ctx, 1000);
    fc_channel_add_delay_time(ctx, "other", 500);
    CHECK_INT(fc_channel_put(ctx, "other", "A", 1), FC_OK);
    fc_channel_add_masquerade(ctx, "c", "other");
    CHECK_TAKE("", 1, "-");
    fc_advance(ctx, 500);
    CHECK_TAKE("", 1, "A");
}

static void put_faults_count_puts(void) {
    start("");
    fc_fault_id fault = fc_channel_add_block_put(ctx, "c");
    fc_trigger_once_after(ctx, fault, 1);
    CHECK_TAKE("", 3, "---"); /* gets do not count */
    CHECK_INT(fc_channel_put(ctx, "c", "A", 1), FC_OK);
    CHECK_INT(fc_channel_put(ctx, "c", "B", 1), FC_E_BLOCKED);
}

int main(void) {
    ctx = fc_new(NULL);
    lose_discards_one_packet_per_get();
    repeat_last_delivers_again_while_the_head_stays();
    the_last_packet_is_known_without_faults_too();
    insert_adds_foreign_packets();
    masquerade_takes_from_another_channel();
    a_small_buffer_leaves_both_channels();
    resequence_delivers_a_later_packet();
    block_delivers_nothing_and_keeps_the_queue();
    truncate_and_extend();
    chosen_packets_pass_the_faults_that_follow();
    fields_are_altered_by_any_model();
    a_field_of_every_type();
    fields_are_checked();
    delay_by_gets_keeps_the_order();
    hidden_packets_cannot_be_dropped();
    delay_by_time();
    misroute_sends_to_another_channel();
    block_refuses_the_put();
    subset_reaches_the_listed_receivers_only();
    asymmetric_alters_the_listed_receivers_copy();
    a_fault_can_be_for_one_receiver();
    channels_know_every_trigger();
    delays_hold_on_the_channels_that_packets_get_to();
    put_faults_count_puts();
    fc_free(ctx);
    return CHECK_RESULT();
}
