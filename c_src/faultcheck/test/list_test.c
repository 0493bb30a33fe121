/* The listing (7.9 of the reference). */
#include "errors.h"

static fc_context *ctx;
static char lines[4000];

static void add_line(void *user, const char *line) {
    (void)user;
    strcat(strcat(lines, line), "\n");
}

static void probe(const char *id) {
    int32_t value = 0;
    fc_probe_i32(ctx, id, &value);
}

#define CHECK_DUMP(expected)                                                                       \
    do {                                                                                           \
        lines[0] = '\0';                                                                           \
        CHECK_INT(fc_dump_json(ctx, add_line, NULL), FC_OK);                                       \
        if (strcmp(lines, expected) != 0) {                                                        \
            check_failures++;                                                                      \
            fprintf(stderr, "%s:%d: got\n%sexpected\n%s", __FILE__, __LINE__, lines, expected);    \
        }                                                                                          \
    } while (0)

static void everything_seen_is_listed_by_name(void) {
    double number = 0;
    fc_reset(ctx);
    probe("b");
    probe("b");
    fc_probe_f64(ctx, "b", &number);
    fc_monitor_bool(ctx, "m", true);
    fc_channel_put(ctx, "b", "x", 1);
    fc_channel_get(ctx, "unknown", "", NULL, 0, NULL);
    fc_trigger_after(ctx, fc_add_offset(ctx, "a", 0.5), 3);
    probe("a");
    CHECK_DUMP("{\"id\":\"a\",\"kind\":\"probe\",\"types\":[\"i32\"],\"calls\":1,\"faults\":["
               "{\"id\":1,\"model\":\"offset\",\"a\":\"0x1p-1\",\"b\":\"0x0p+0\",\"n\":0,"
               "\"state\":\"waiting\",\"calls_left\":2,\"triggered\":0,\"applied\":0,"
               "\"skipped\":0,\"last_error\":\"FC_OK\"}]}\n"
               "{\"id\":\"b\",\"kind\":\"probe\",\"types\":[\"f64\",\"i32\"],\"calls\":0,"
               "\"faults\":[]}\n"
               "{\"id\":\"b\",\"kind\":\"channel\",\"gets\":0,\"puts\":1,\"faults\":[]}\n"
               "{\"id\":\"m\",\"kind\":\"probe\",\"types\":[\"bool\"],\"calls\":1,"
               "\"faults\":[]}\n");
    fc_reset(ctx);
    CHECK_DUMP("");
    probe("m");
    CHECK_DUMP("{\"id\":\"m\",\"kind\":\"probe\",\"types\":[\"i32\"],\"calls\":0,\"faults\":[]}\n");
}

static void idle_calls_are_counted_on_request(void) {
    fc_reset(ctx);
    probe("p");
    fc_count_calls(ctx, true);
    probe("p");
    probe("new");
    probe("new");
    CHECK_DUMP("{\"id\":\"new\",\"kind\":\"probe\",\"types\":[\"i32\"],\"calls\":2,\"faults\":[]}\n"
               "{\"id\":\"p\",\"kind\":\"probe\",\"types\":[\"i32\"],\"calls\":1,\"faults\":[]}\n");
    fc_count_calls(ctx, false);
    probe("p");
    fc_reset(ctx);
    probe("p");
    CHECK_DUMP("{\"id\":\"p\",\"kind\":\"probe\",\"types\":[\"i32\"],\"calls\":0,\"faults\":[]}\n");
}

static fc_listed_fault faults[10];
static char receivers[10][8]; /* what the listing points to is gone after the visit */
static int fault_count;

static void keep_faults(void *user, const fc_listed *listed) {
    (void)user;
    for (size_t at = 0; at < listed->fault_count; at++) {
        snprintf(receivers[fault_count], sizeof receivers[0], "%s", listed->faults[at].receiver);
        faults[fault_count++] = listed->faults[at];
    }
}

static void list(void) {
    fault_count = 0;
    CHECK_INT(fc_list(ctx, keep_faults, NULL), FC_OK);
}

static void the_state_of_a_fault_is_told(void) {
    fc_reset(ctx);
    errors_start(ctx);
    fc_fault_id fault = fc_add_bitflip(ctx, "p", 40);
    fc_trigger_duration(ctx, fault, 3);
    list();
    CHECK_INT(faults[0].state, FC_ACTIVE);
    CHECK_INT(faults[0].n, 40);
    probe("p"); /* skipped: an int has no bit 40 */
    double number = 0;
    fc_probe_f64(ctx, "p", &number);
    fc_probe_f64(ctx, "p", &number);
    list();
    CHECK_INT(faults[0].state, FC_EXHAUSTED);
    CHECK_INT(faults[0].triggered, 3);
    CHECK_INT(faults[0].applied, 2);
    CHECK_INT(faults[0].skipped, 1);
    CHECK_INT(faults[0].last_error, FC_E_BIT);
    fc_enable(ctx, fault, false);
    list();
    CHECK_INT(faults[0].state, FC_DISABLED);
    fc_remove(ctx, fault); /* the identifier and its calls stay */
    list();
    CHECK_INT(fault_count, 0);
    CHECK_DUMP("{\"id\":\"p\",\"kind\":\"probe\",\"types\":[\"f64\",\"i32\"],\"calls\":3,"
               "\"faults\":[]}\n");
}

static void channel_faults_are_listed_per_receiver(void) {
    char data[4];
    fc_reset(ctx);
    fc_channel_subscribe(ctx, "c", "r");
    fc_fault_id drop = fc_channel_add_drop(ctx, "c", 1);
    fc_fault_id repeat = fc_channel_add_repeat(ctx, "c", 1);
    fc_channel_fault_receiver(ctx, repeat, "r");
    fc_channel_add_block_put(ctx, "c");
    fc_channel_get(ctx, "c", "r", data, 4, NULL);
    list();
    CHECK_INT(fault_count, 4);
    CHECK(faults[0].id == drop && strcmp(receivers[0], "") == 0);
    CHECK_INT(faults[0].triggered, 0);
    CHECK(faults[1].id == drop && strcmp(receivers[1], "r") == 0);
    CHECK_INT(faults[1].triggered, 1);
    CHECK_INT(faults[1].applied, 0); /* there was no packet */
    CHECK(faults[2].id == repeat && strcmp(receivers[2], "r") == 0);
    CHECK(strcmp(faults[3].model, "block_put") == 0);
}

static uint64_t changes;

static bool has_changed(void) {
    uint64_t before = changes;
    changes = fc_change_count(ctx);
    return changes != before;
}

static void changes_are_counted(void) {
    double value = 1;
    fc_reset(ctx);
    CHECK(has_changed());
    CHECK(!fc_is_watching(ctx));
    fc_fault_id offset = fc_add_offset(ctx, "p", 1);
    CHECK(has_changed());
    fc_probe_f64(ctx, "p", &value);
    fc_probe_f64(ctx, "q", &value);
    CHECK(!has_changed());
    fc_remove(ctx, offset);
    CHECK(has_changed());
    fc_channel_add_drop(ctx, "c", 1);
    CHECK(has_changed());
    fc_channel_remove_faults(ctx, "c");
    CHECK(has_changed());
    fc_count_calls(ctx, true);
    CHECK(has_changed());
    CHECK(fc_is_watching(ctx));
    fc_count_calls(ctx, false);
    CHECK(!fc_is_watching(ctx));
    fc_record_start(ctx, NULL);
    CHECK(fc_is_watching(ctx));
    CHECK(has_changed());
    fc_record_stop(ctx);
    CHECK(has_changed());
}

/* Without a function to visit; the copy stays as it is. */
static void a_listing_is_a_copy(void) {
    fc_reset(ctx);
    fc_add_offset(ctx, "p", 1);
    fc_channel_put(ctx, "c", "x", 1);
    fc_listing *listing = fc_listing_new(ctx);
    fc_reset(ctx);
    const fc_listed *channel = fc_listing_at(listing, 0), *probed = fc_listing_at(listing, 1);
    CHECK(strcmp(channel->id, "c") == 0 && channel->is_channel && channel->fault_count == 0);
    CHECK(strcmp(probed->id, "p") == 0 && !probed->is_channel && probed->fault_count == 1);
    CHECK(strcmp(probed->faults[0].model, "offset") == 0);
    CHECK(fc_listing_at(listing, 2) == NULL);
    fc_listing_free(listing);
    fc_listing_free(NULL);
    listing = fc_listing_new(ctx);
    CHECK(fc_listing_at(listing, 0) == NULL);
    fc_listing_free(listing);
}

int main(void) {
    ctx = fc_new(NULL);
    a_listing_is_a_copy();
    everything_seen_is_listed_by_name();
    idle_calls_are_counted_on_request();
    the_state_of_a_fault_is_told();
    channel_faults_are_listed_per_receiver();
    changes_are_counted();
    fc_free(ctx);
    return CHECK_RESULT();
}
