/* Keeping and restoring the state of a context: fc_snapshot.h. */
#include "errors.h"

#include <math.h>
#include <stdlib.h>

static fc_context *ctx;

/* What a program sees, as text. */
static char seen[1 << 17];
static size_t seen_len;

static void see(const char *text) {
    const size_t len = strlen(text);
    if (seen_len + len + 2 > sizeof seen) {
        CHECK(!"room for all of it");
        return;
    }
    memcpy(seen + seen_len, text, len);
    seen_len += len;
    seen[seen_len++] = '\n';
    seen[seen_len] = '\0';
}

static void see_line(void *user, const char *line) {
    (void)user;
    see(line);
}

static void see_double(const char *what, double value) {
    char text[80];
    snprintf(text, sizeof text, "%s %a", what, value);
    see(text);
}

static char *take_seen(void) {
    char *copy = malloc(seen_len + 1);
    if (copy == NULL)
        exit(1);
    seen[seen_len] = '\0';
    memcpy(copy, seen, seen_len + 1);
    seen_len = 0;
    return copy;
}

static void quiet(void *user, const fc_error *error) {
    (void)user;
    see(error->text);
}

static bool only_sometimes(void *user) {
    return ++*(int *)user % 3 == 0;
}

/* Every model of a probe, each with another trigger. */
static void arm_probes(void) {
    static const fc_model models[] = {{FC_BITFLIP, 0, 0, 51},
                                      {FC_BITFLIP_RANDOM, 0, 0, 0},
                                      {FC_STUCK, 0, 0, 0},
                                      {FC_STUCK_BIT, 1, 0, 50},
                                      {FC_AMPLIFICATION, 1.5, 0, 0},
                                      {FC_OFFSET, 2, 0, 0},
                                      {FC_SET_TO, 7, 0, 0},
                                      {FC_NOISE_UNIFORM, 3, 0, 0},
                                      {FC_NOISE_GAUSS, 1, 0, 0},
                                      {FC_RANDOM_OFFSET, 1, 2, 0},
                                      {FC_DRIFT, 0.5, 9, 0},
                                      {FC_DRIFT_TIMED, 4, 99, 0},
                                      {FC_RAMP, 20, 0, 30},
                                      {FC_DELAY, 0, 0, 5},
                                      {FC_QUANTISE, 0.25, 0, 0},
                                      {FC_DEAD_ZONE, 0, 1, 0},
                                      {FC_SATURATE, -5, 5, 0},
                                      {FC_OSCILLATE, 3, 0, 17},
                                      {FC_DROPOUT, 0.5, 0, FC_HOLD},
                                      {FC_SPIKE, 0.3, 8, 0},
                                      {FC_HELD_OFFSET, -2, 2, 4000000}};
    const int count = sizeof models / sizeof *models;
    for (int i = 0; i < count; i++) {
        char name[20];
        snprintf(name, sizeof name, "p%d", i / 2);
        const fc_fault_id fault = fc_add_model(ctx, name, &models[i]);
        CHECK(fault > 0);
        if (i % 5 == 1) {
            fc_trigger_after(ctx, fault, 12);
            fc_trigger_duration(ctx, fault, 9);
        } else if (i % 5 == 2) {
            fc_trigger_random(ctx, fault, 0.5);
        } else if (i % 5 == 3) {
            fc_trigger_time(ctx, fault, 3000000, 30000000);
        } else if (i % 5 == 4) {
            fc_trigger_periodic(ctx, fault, 7, 4);
        }
        if (i == 9)
            fc_enable(ctx, fault, false);
    }
}

static void arm_channels(void) {
    static const char *const some[] = {"left"};
    const fc_field field = {0, FC_U16, true, 0};
    const fc_model noise = {FC_BITFLIP_RANDOM, 0, 0, 0};
    fc_channel_subscribe(ctx, "bus", "left");
    fc_channel_subscribe(ctx, "bus", "right");
    fc_trigger_random(ctx, fc_channel_add_field(ctx, "bus", &field, &noise), 0.5);
    fc_trigger_after(ctx, fc_channel_add_drop(ctx, "bus", 5), 6);
    fc_trigger_random(ctx, fc_channel_add_resequence(ctx, "bus", 1), 0.3);
    fc_channel_fault_receiver(ctx, fc_channel_add_repeat(ctx, "bus", 4), "right");
    fc_trigger_random(ctx, fc_channel_add_delay(ctx, "bus", 3), 0.4);
    fc_trigger_random(ctx, fc_channel_add_subset(ctx, "bus", some, 1), 0.2);
    fc_trigger_periodic(ctx, fc_channel_add_repeat_last(ctx, "bus"), 5, 1);
    fc_channel_add_delay_time(ctx, "slow", 7000000);
    fc_trigger_random(ctx, fc_channel_add_misroute(ctx, "slow", "other"), 0.4);
    fc_trigger_random(ctx, fc_channel_add_masquerade(ctx, "bus", "other"), 0.3);
    fc_trigger_random(ctx, fc_channel_add_insert(ctx, "other", "in", 2, 3), 0.2);
}

static void get_all(const char *channel, const char *receiver) {
    char data[32];
    for (int i = 0; i < 3; i++) {
        size_t len = 0;
        const int got = fc_channel_get(ctx, channel, receiver, data, sizeof data, &len);
        char text[120];
        int at = snprintf(text, sizeof text, "%s %s %d:", channel, receiver, got);
        for (size_t byte = 0; got == 1 && byte < len; byte++)
            at += snprintf(text + at, sizeof text - (size_t)at, " %02x", (unsigned char)data[byte]);
        see(text);
    }
}

static void run(int from, int to) {
    for (int step = from; step < to; step++) {
        fc_advance(ctx, 1000000);
        for (int probe = 0; probe < 12; probe++) {
            char name[20];
            snprintf(name, sizeof name, "p%d", probe);
            double value = sin(step);
            fc_probe_f64(ctx, name, &value);
            see_double(name, value);
        }
        int32_t whole = step;
        fc_probe_i32(ctx, "p2", &whole);
        see_double("p2 as int", whole);
        char packet[8];
        const int len = snprintf(packet, sizeof packet, "%d", step);
        fc_channel_put(ctx, "bus", packet, (size_t)len);
        fc_channel_put(ctx, "slow", packet, (size_t)len);
        get_all("bus", "left");
        get_all("bus", "right");
        get_all("slow", "");
        get_all("other", "");
    }
    see_double("now", (double)fc_now(ctx));
    see_double("errors", (double)fc_error_count(ctx));
}

static char *dump(void) {
    CHECK_INT(fc_dump_json(ctx, see_line, NULL), FC_OK);
    return take_seen();
}

static char *rest(void) {
    run(20, 40);
    fc_add_noise_uniform(ctx, "p11", 1); /* a stream of the seed kept */
    run(40, 45);
    CHECK_INT(fc_dump_json(ctx, see_line, NULL), FC_OK);
    see_double("next fault", (double)fc_add_offset(ctx, "p0", 1));
    return take_seen();
}

#define CHECK_SAME(text, expected)                                                                 \
    do {                                                                                           \
        char *check_text = (text);                                                                 \
        CHECK(strcmp(check_text, expected) == 0);                                                  \
        free(check_text);                                                                          \
    } while (0)

static void start(void) {
    ctx = fc_new(NULL);
    fc_set_error_callback(ctx, quiet, NULL);
}

static void everything_goes_on_as_after_the_save(void) {
    static int asked;
    start();
    fc_advance(ctx, 1);
    arm_probes();
    arm_channels();
    fc_trigger_when(ctx, fc_add_offset(ctx, "p10", 3), only_sometimes, &asked);
    fc_add_bitflip(ctx, "p1", -1); /* refused: no fault to change any more */
    run(0, 20);
    seen_len = 0;
    char *listed = dump();
    const int asked_so_far = asked;
    fc_snapshot *snapshot = fc_save(ctx);
    CHECK(snapshot != NULL);
    CHECK_SAME(dump(), listed);
    char *first = rest();
    CHECK(strstr(first, "bus left 1:") != NULL);

    asked = asked_so_far;
    CHECK_INT(fc_restore(ctx, snapshot), FC_OK);
    CHECK_SAME(dump(), listed);
    CHECK_SAME(rest(), first);

    fc_channel_remove_all_faults(ctx); /* a very different state in between */
    fc_channel_clear(ctx, "bus");
    fc_seed(ctx, 99);
    fc_channel_put(ctx, "new", "packet", 6);
    fc_channel_add_lose(ctx, "newer");
    fc_add_offset(ctx, "newest", 1);
    fc_count_calls(ctx, true);
    run(0, 3);
    seen_len = 0;
    asked = asked_so_far;
    CHECK_INT(fc_restore(ctx, snapshot), FC_OK);
    CHECK_SAME(dump(), listed);
    CHECK_SAME(rest(), first);

    fc_reset(ctx);
    asked = asked_so_far;
    CHECK_INT(fc_restore(ctx, snapshot), FC_OK);
    CHECK_SAME(dump(), listed);
    CHECK_SAME(rest(), first);

    fc_release(snapshot);
    free(listed);
    free(first);
    fc_free(ctx);
}

static void an_empty_state_comes_back(void) {
    start();
    fc_snapshot *snapshot = fc_save(ctx);
    char *empty = dump();
    CHECK_INT(strlen(empty), 0);
    arm_probes();
    arm_channels();
    run(0, 5);
    seen_len = 0;
    fc_restore(ctx, snapshot);
    CHECK_SAME(dump(), empty);
    CHECK_INT(fc_add_offset(ctx, "p", 1), 1); /* ids from the start */
    CHECK_INT(fc_error_count(ctx), 0);
    free(empty);
    fc_release(snapshot);
    fc_free(ctx);
}

static double probe(fc_handle *handle, double value) {
    fc_probe_f64_at(handle, &value);
    return value;
}

static void handles_stay_good(void) {
    start();
    errors_start(ctx);
    fc_handle handle;
    fc_channel_handle channel, queue;
    fc_resolve(ctx, "p", FC_F64, &handle);
    fc_resolve_channel(ctx, "c", &channel);
    fc_resolve_channel(ctx, "q", &queue);
    probe(&handle, 1);
    fc_snapshot *idle = fc_save(ctx);
    fc_trigger_duration(ctx, fc_add_offset(ctx, "p", 2), 1);
    fc_channel_add_lose(ctx, "c");
    fc_channel_put_at(&queue, "a", 1);
    fc_snapshot *armed = fc_save(ctx);
    CHECK_BITS(probe(&handle, 1), 3);
    CHECK_BITS(probe(&handle, 1), 1);
    for (int round = 0; round < 3; round++) {
        fc_restore(ctx, idle);
        CHECK(fc_handle_is_idle(&handle));
        CHECK(fc_channel_is_idle(&channel));
        CHECK(fc_channel_is_idle(&queue));
        CHECK_BITS(probe(&handle, 1), 1);
        const uint64_t changes = fc_change_count(ctx);
        fc_restore(ctx, armed);
        CHECK(fc_change_count(ctx) != changes);
        CHECK(!fc_handle_is_idle(&handle));
        CHECK(!fc_channel_is_idle(&channel));
        CHECK(!fc_channel_is_idle(&queue));
        CHECK_INT(fc_channel_depth_at(&queue, ""), 1);
        CHECK_BITS(probe(&handle, 1), 3);
        CHECK_BITS(probe(&handle, 1), 1);
    }
    CHECK_NO_ERROR();
    fc_release(idle);
    fc_release(armed);
    fc_free(ctx);
}

static void fault_ids_lead_to_the_restored_faults(void) {
    start();
    errors_start(ctx);
    const fc_fault_id kept = fc_add_offset(ctx, "p", 1);
    const fc_fault_id queued = fc_channel_add_lose(ctx, "c");
    fc_snapshot *snapshot = fc_save(ctx);
    fc_remove(ctx, kept);
    fc_remove(ctx, queued);
    const fc_fault_id later = fc_add_offset(ctx, "p", 10);
    fc_restore(ctx, snapshot);
    CHECK_INT(fc_enable(ctx, later, false), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "no fault");
    CHECK_INT(fc_latest(ctx, "p"), kept);
    CHECK_INT(fc_channel_latest(ctx, "c"), queued);
    CHECK_INT(fc_remove(ctx, kept), FC_OK);
    CHECK_INT(fc_remove(ctx, queued), FC_OK);
    CHECK_INT(fc_add_offset(ctx, "p", 10), later);
    CHECK_NO_ERROR();
    fc_release(snapshot);
    fc_free(ctx);
}

/* The recording goes on over the restore, and so does the choice of the clock. */
static void recordings_and_clocks_are_left_alone(void) {
    start();
    fc_snapshot *snapshot = fc_save(ctx);
    double value = 1;
    fc_record_start(ctx, NULL);
    fc_probe_f64(ctx, "p", &value);
    const size_t before = fc_record_copy(ctx, NULL, 0);
    fc_restore(ctx, snapshot);
    CHECK_INT(fc_record_copy(ctx, NULL, 0), before);
    fc_probe_f64(ctx, "p", &value);
    CHECK(fc_record_copy(ctx, NULL, 0) > before);
    fc_record_stop(ctx);
    fc_advance(ctx, 5);
    fc_restore(ctx, snapshot);
    CHECK_INT(fc_now(ctx), 0);
    fc_release(snapshot);
    fc_free(ctx);
}

static void what_cannot_be_restored_is_refused(void) {
    start();
    errors_start(ctx);
    fc_add_offset(ctx, "p", 1);
    CHECK_INT(fc_restore(ctx, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "the snapshot is NULL");
    fc_snapshot *of_default = fc_save(NULL);
    CHECK_INT(fc_restore(ctx, of_default), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "of another context");
    CHECK_INT(fc_restore(NULL, of_default), FC_OK);
    fc_context *gone = fc_new(NULL);
    fc_snapshot *of_gone = fc_save(gone);
    fc_free(gone);
    for (int i = 0; i < 4; i++) { /* perhaps where the other one was */
        fc_context *next = fc_new(NULL);
        errors_start(next);
        CHECK_INT(fc_restore(next, of_gone), FC_E_ARG);
        CHECK_ERROR(FC_E_ARG, "of another context");
        fc_free(next);
    }
    double value = 1;
    fc_probe_f64(ctx, "p", &value);
    CHECK_BITS(value, 2);
    fc_release(of_gone);
    fc_release(of_default);
    fc_release(NULL);
    fc_free(ctx);
}

int main(void) {
    everything_goes_on_as_after_the_save();
    an_empty_state_comes_back();
    handles_stay_good();
    fault_ids_lead_to_the_restored_faults();
    recordings_and_clocks_are_left_alone();
    what_cannot_be_restored_is_refused();
    return CHECK_RESULT();
}
