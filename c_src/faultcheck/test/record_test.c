/* Monitors, recordings and their comparison (7.8 of the reference). */
#define _POSIX_C_SOURCE 200809L
#include "errors.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

static fc_context *ctx;
static char lines[4000];

static void add_line(void *user, const char *line) {
    (void)user;
    strcat(strcat(lines, line), "\n");
}

typedef struct {
    char data[4000];
    size_t len;
} recording;

static recording stop(void) {
    recording result;
    CHECK_INT(fc_record_stop(ctx), FC_OK);
    result.len = fc_record_copy(ctx, result.data, sizeof result.data);
    CHECK(result.len <= sizeof result.data);
    return result;
}

static void start(void) {
    fc_reset(ctx);
    errors_start(ctx);
    errors_start(NULL);
    fc_advance(ctx, 5);
    CHECK_INT(fc_record_start(ctx, NULL), FC_OK);
}

static void probe(const char *id, double value) {
    fc_probe_f64(ctx, id, &value);
}

static void the_text_form_tells_everything(void) {
    char data[8];
    int32_t number = 7;
    bool truth = true;
    start();
    fc_add_offset(ctx, "x\"\xff", 0.5);
    probe("x\"\xff", 1);
    fc_advance(ctx, 10);
    fc_probe_i32(ctx, "n", &number);
    fc_probe_bool(ctx, "n", &truth);
    fc_monitor_u8(ctx, "m", 200);
    fc_monitor_f32(ctx, "m", 0.1f);
    fc_monitor_bytes(ctx, "m", "\x01\xab", 2);
    fc_channel_put(ctx, "n", "AB", 2);
    fc_channel_add_corruption(ctx, "n", 0, 0);
    fc_channel_get(ctx, "n", "", data, sizeof data, NULL);
    fc_channel_get(ctx, "n", "", data, sizeof data, NULL); /* nothing delivered, nothing recorded */
    recording made = stop();
    probe("n", 1); /* not any more */
    CHECK_INT(fc_record_copy(ctx, NULL, 0), made.len);
    lines[0] = '\0';
    CHECK_INT(fc_record_text(made.data, made.len, add_line, NULL), FC_OK);
    const char *expected =
        "{\"sequence\":0,\"time_ns\":5,\"kind\":\"probe\",\"id\":\"x\\\"\\u00ff\",\"type\":\"f64\","
        "\"before\":\"0x1p+0\",\"after\":\"0x1.8p+0\",\"faults\":1}\n"
        "{\"sequence\":1,\"time_ns\":15,\"kind\":\"probe\",\"id\":\"n\",\"type\":\"i32\","
        "\"before\":7,\"after\":7,\"faults\":0}\n"
        "{\"sequence\":2,\"time_ns\":15,\"kind\":\"probe\",\"id\":\"n\",\"type\":\"bool\","
        "\"before\":true,\"after\":true,\"faults\":0}\n"
        "{\"sequence\":3,\"time_ns\":15,\"kind\":\"monitor\",\"id\":\"m\",\"type\":\"u8\","
        "\"before\":200,\"after\":200,\"faults\":0}\n"
        "{\"sequence\":4,\"time_ns\":15,\"kind\":\"monitor\",\"id\":\"m\",\"type\":\"f32\","
        "\"before\":\"0x1.99999ap-4\",\"after\":\"0x1.99999ap-4\",\"faults\":0}\n"
        "{\"sequence\":5,\"time_ns\":15,\"kind\":\"monitor\",\"id\":\"m\",\"type\":\"bytes\","
        "\"before\":\"01ab\",\"after\":\"01ab\",\"faults\":0}\n"
        "{\"sequence\":6,\"time_ns\":15,\"kind\":\"put\",\"id\":\"n\",\"type\":\"bytes\","
        "\"before\":\"4142\",\"after\":\"4142\",\"faults\":0}\n"
        "{\"sequence\":7,\"time_ns\":15,\"kind\":\"get\",\"id\":\"n\",\"type\":\"bytes\","
        "\"before\":\"4042\",\"after\":\"4042\",\"faults\":0}\n";
    if (strcmp(lines, expected) != 0) {
        CHECK(!"the text form");
        fprintf(stderr, "%s", lines);
    }
}

static void a_file_holds_the_same_bytes(void) {
    char file[] = "/tmp/fc_record_XXXXXX", data[4000];
    recording memory = {{0}, 0};
    const int descriptor = mkstemp(file);
    for (int round = 0; round < 2; round++) {
        fc_reset(ctx);
        CHECK_INT(fc_record_start(ctx, round == 0 ? NULL : file), FC_OK);
        for (int at = 0; at < 20; at++)
            probe("p", at);
        if (round == 0)
            memory = stop();
        else
            CHECK_INT(fc_record_stop(ctx), FC_OK);
    }
    CHECK_INT(fc_record_copy(ctx, NULL, 0), 0);
    CHECK_INT(read(descriptor, data, sizeof data), memory.len);
    CHECK(memcmp(data, memory.data, memory.len) == 0);
    close(descriptor);
    unlink(file);
}

static void a_long_recording_grows(void) {
    start();
    for (int at = 0; at < 20000; at++)
        probe("p", at);
    CHECK_INT(fc_record_stop(ctx), FC_OK);
    CHECK_INT(fc_record_copy(ctx, NULL, 0), 8 + 1 + 1 + 4 + 1 + 20000 * (27 + 16));
}

static void files_that_cannot_be_written(void) {
    start();
    CHECK_INT(fc_record_start(ctx, "/nowhere/at/all"), FC_E_IO);
    CHECK_ERROR(FC_E_IO, "/nowhere/at/all");
    CHECK_INT(fc_record_start(ctx, "/dev/full"), FC_OK);
    probe("p", 1);
    CHECK_INT(fc_record_stop(ctx), FC_E_IO);
    CHECK_ERROR(FC_E_IO, "cannot be written");
    CHECK_INT(fc_record_stop(ctx), FC_OK);
    CHECK_INT(fc_monitor_bytes(ctx, "p", NULL, 1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "NULL");
}

static fc_divergence found[10];
static char names[10][20];
static int count;

static void add_divergence(void *user, const fc_divergence *divergence) {
    (void)user;
    found[count] = *divergence;
    snprintf(names[count], sizeof names[count], "%s", divergence->id);
    count++;
}

static int compare(const recording *golden, const recording *run, double absolute,
                   double relative) {
    const fc_tolerance tolerance = {absolute, relative};
    count = 0;
    const int result = fc_compare(golden->data, golden->len, run->data, run->len, &tolerance,
                                  add_divergence, NULL);
    CHECK_INT(result, count);
    fc_comparison *same =
        fc_comparison_new(golden->data, golden->len, run->data, run->len, &tolerance);
    for (int at = 0; at < count; at++) {
        const fc_divergence *other = fc_comparison_at(same, (size_t)at);
        CHECK(strcmp(other->id, names[at]) == 0);
        CHECK_INT(other->first, found[at].first);
        CHECK_INT(other->extra, found[at].extra);
        CHECK_BITS(other->largest_absolute, found[at].largest_absolute);
    }
    CHECK(fc_comparison_at(same, (size_t)count) == NULL);
    fc_comparison_free(same);
    return result;
}

/* A chain of three values; the first gets an error at its third call. */
static recording run_chain(bool faulty) {
    start();
    if (faulty)
        fc_trigger_once_after(ctx, fc_add_offset(ctx, "sensor", 1), 2);
    for (int at = 0; at < 5; at++) {
        double sensor = 10 + at;
        fc_probe_f64(ctx, "sensor", &sensor);
        fc_monitor_f64(ctx, "filter", sensor / 2);
        fc_monitor_i32(ctx, "alarm", sensor > 12.5 && sensor < 14);
        fc_monitor_f64(ctx, "same", NAN);
        fc_advance(ctx, 100);
    }
    return stop();
}

static void divergences_come_in_the_order_of_propagation(void) {
    const recording golden = run_chain(false), faulty = run_chain(true);
    CHECK_INT(compare(&golden, &golden, 0, 0), 0);
    CHECK_INT(compare(&golden, &faulty, 0, 0), 3);
    CHECK(strcmp(names[0], "sensor") == 0);
    CHECK(strcmp(names[1], "filter") == 0);
    CHECK(strcmp(names[2], "alarm") == 0);
    CHECK_INT(found[0].calls, 5);
    CHECK_INT(found[0].differing, 1);
    CHECK_INT(found[0].first, 2);
    CHECK_INT(found[0].first_ns, 205);
    CHECK_BITS(found[0].largest_absolute, 1);
    CHECK_BITS(found[0].largest_relative, 1.0 / 12);
    CHECK_BITS(found[1].largest_absolute, 0.5);
    CHECK_INT(compare(&golden, &faulty, 0.5, 0), 2);
    CHECK_INT(compare(&golden, &faulty, 0, 0.1), 1); /* the alarm: from 0 to 1 */
    CHECK_INT(compare(&golden, &faulty, 1, 0), 0);
}

static void missing_and_extra_calls(void) {
    start();
    probe("a", 1);
    probe("a", 2);
    probe("only golden", 2);
    fc_channel_put(ctx, "a", "x", 1);
    recording golden = stop();
    start();
    probe("a", 1);
    probe("only run", 2);
    fc_channel_put(ctx, "a", "y", 1);
    recording run = stop();
    CHECK_INT(compare(&golden, &run, 0, 0), 4);
    CHECK(strcmp(names[0], "only run") == 0 && found[0].extra == 1 && found[0].first == 0);
    CHECK(strcmp(names[1], "a") == 0 && found[1].is_channel && found[1].differing == 1);
    CHECK(strcmp(names[2], "a") == 0 && !found[2].is_channel && found[2].missing == 1);
    CHECK_INT(found[2].first, 1);
    CHECK_INT(found[2].first_ns, 5);
    CHECK(strcmp(names[3], "only golden") == 0 && found[3].missing == 1);
}

static void damaged_recordings_are_refused(void) {
    const recording good = run_chain(true);
    recording bad = good;
    for (size_t len = 0; len < good.len; len++) { /* cut anywhere: never read beyond the end */
        char *exact = malloc(len + 1);
        memcpy(exact, good.data, len);
        lines[0] = '\0';
        const int result = fc_record_text(exact, len, add_line, NULL);
        CHECK(result == FC_OK || result == FC_E_FORMAT);
        free(exact);
    }
    errors_seen = 0;
    CHECK_INT(fc_record_text("FCREC002", 8, add_line, NULL), FC_E_FORMAT);
    CHECK_ERROR(FC_E_FORMAT, "byte 0");
    bad.data[8] = 'Q';
    CHECK_INT(fc_compare(bad.data, bad.len, good.data, good.len, NULL, add_divergence, NULL),
              FC_E_FORMAT);
    CHECK_ERROR(FC_E_FORMAT, "golden recording, byte 8: an entry of an unknown kind");
    CHECK_INT(fc_compare(good.data, good.len, good.data, good.len - 1, NULL, add_divergence, NULL),
              FC_E_FORMAT);
    CHECK_ERROR(FC_E_FORMAT, "cut off");
    bad = good;
    bad.data[9] = 7;
    CHECK_INT(fc_record_text(bad.data, bad.len, add_line, NULL), FC_E_FORMAT);
    CHECK_ERROR(FC_E_FORMAT, "neither of a probe nor of a channel");
}

int main(void) {
    ctx = fc_new(NULL);
    the_text_form_tells_everything();
    a_file_holds_the_same_bytes();
    a_long_recording_grows();
    files_that_cannot_be_written();
    divergences_come_in_the_order_of_propagation();
    missing_and_extra_calls();
    damaged_recordings_are_refused();
    fc_free(ctx);
    return CHECK_RESULT();
}
