/* Probes and channels that are looked up once: fc_resolve.h. */
#include "errors.h"

static fc_context *ctx;

static void start(void) {
    ctx = fc_new(NULL);
    errors_start(ctx);
}

static void finish(void) {
    CHECK_NO_ERROR();
    fc_free(ctx);
}

static void count_listed(void *user, const fc_listed *listed) {
    (void)listed;
    ++*(int *)user;
}

static int listed(void) {
    int count = 0;
    fc_list(ctx, count_listed, &count);
    return count;
}

static double probe(fc_handle *handle, double value) {
    CHECK_INT(fc_probe_f64_at(handle, &value), FC_OK);
    return value;
}

static void a_resolved_probe_is_that_of_its_context(void) {
    start();
    fc_handle handle, same;
    CHECK_INT(fc_resolve(ctx, "p", FC_F64, &handle), FC_OK);
    CHECK_INT(listed(), 0);
    fc_add_offset(NULL, "p", 100); /* another context */
    CHECK_BITS(probe(&handle, 1), 1);
    CHECK_INT(listed(), 1);
    fc_fault_id fault = fc_add_offset(ctx, "p", 2);
    CHECK_BITS(probe(&handle, 1), 3);
    CHECK_INT(fc_num_active(ctx, "p"), 1);
    CHECK_INT(fc_resolve(ctx, "p", FC_F64, &same), FC_OK);
    CHECK(same.probe == handle.probe && same.state == handle.state);
    fc_remove(ctx, fault);
    CHECK_BITS(probe(&same, 1), 1);
    fc_reset(NULL);
    finish();
}

static void a_handle_survives_a_reset_and_other_names(void) {
    start();
    fc_handle handle;
    fc_resolve(ctx, "p", FC_F64, &handle);
    for (int i = 0; i < 1000; i++) { /* the table grows */
        char name[20];
        snprintf(name, sizeof name, "other%d", i);
        fc_add_offset(ctx, name, 1);
    }
    fc_reset(ctx);
    fc_add_offset(ctx, "p", 5);
    CHECK_BITS(probe(&handle, 1), 6);
    fc_reset(ctx);
    CHECK_BITS(probe(&handle, 1), 1);
    CHECK_INT(listed(), 1);
    finish();
}

static void idle_tells_whether_a_call_does_anything(void) {
    start();
    fc_handle handle, other_type;
    fc_resolve(ctx, "p", FC_F64, &handle);
    fc_resolve(ctx, "p", FC_I32, &other_type);
    CHECK(!fc_handle_is_idle(&handle)); /* the first call lists it */
    probe(&handle, 1);
    CHECK(fc_handle_is_idle(&handle));
    CHECK(!fc_handle_is_idle(&other_type));
    fc_fault_id fault = fc_add_offset(ctx, "p", 1);
    CHECK(!fc_handle_is_idle(&handle));
    fc_remove(ctx, fault);
    CHECK(fc_handle_is_idle(&handle));
    fc_count_calls(ctx, true);
    CHECK(!fc_handle_is_idle(&handle));
    fc_count_calls(ctx, false);
    CHECK(fc_handle_is_idle(&handle));
    fc_reset(ctx);
    CHECK(!fc_handle_is_idle(&handle));
    finish();
}

#define CHECK_TYPE(suffix, kind, type)                                                             \
    do {                                                                                           \
        fc_handle handle;                                                                          \
        type by_handle = 1, by_name = 1;                                                           \
        CHECK_INT(fc_resolve(ctx, "any", kind, &handle), FC_OK);                                   \
        CHECK_INT(fc_probe_##suffix##_at(&handle, &by_handle), FC_OK);                             \
        fc_probe_##suffix(ctx, "any", &by_name);                                                   \
        CHECK(by_handle == by_name && by_handle != 1);                                             \
    } while (0)

static void every_type_can_be_resolved(void) {
    start();
    fc_add_bitflip(ctx, "any", 0);
    CHECK_TYPE(f32, FC_F32, float);
    CHECK_TYPE(f64, FC_F64, double);
    CHECK_TYPE(i8, FC_I8, int8_t);
    CHECK_TYPE(i16, FC_I16, int16_t);
    CHECK_TYPE(i32, FC_I32, int32_t);
    CHECK_TYPE(i64, FC_I64, int64_t);
    CHECK_TYPE(u8, FC_U8, uint8_t);
    CHECK_TYPE(u16, FC_U16, uint16_t);
    CHECK_TYPE(u32, FC_U32, uint32_t);
    CHECK_TYPE(u64, FC_U64, uint64_t);
    CHECK_TYPE(bool, FC_BOOL, bool);
    fc_handle handle;
    unsigned char bytes[2] = {8, 8};
    CHECK_INT(fc_resolve(ctx, "any", FC_BYTES, &handle), FC_OK);
    CHECK_INT(fc_probe_bytes_at(&handle, bytes, sizeof bytes), FC_OK);
    CHECK(bytes[0] == 9 && bytes[1] == 8);
    finish();
}

static void what_cannot_be_resolved_is_refused(void) {
    start();
    fc_handle handle = {NULL, NULL, NULL};
    fc_channel_handle channel = {NULL, NULL, NULL};
    CHECK_INT(fc_resolve(ctx, "p", FC_F64, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "the handle is NULL");
    CHECK_INT(fc_resolve(ctx, "p", 99, &handle), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "no such type");
    CHECK(handle.state == NULL);
    CHECK_INT(fc_resolve_channel(ctx, "c", NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "the handle is NULL");
    fc_resolve(ctx, "p", FC_F64, &handle);
    CHECK_INT(fc_probe_f64_at(&handle, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "value is NULL");
    fc_resolve_channel(ctx, "c", &channel);
    CHECK_INT(fc_channel_put_at(&channel, NULL, 1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "channel \"c\": data is NULL");
    CHECK_INT(fc_channel_get_at(&channel, "", NULL, 1, NULL), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "data is NULL");
    finish();
}

static int get(const fc_channel_handle *handle) {
    char data[8] = {0};
    size_t len = 0;
    const int result = fc_channel_get_at(handle, "", data, sizeof data, &len);
    return result == 1 ? data[0] : -result;
}

static void a_resolved_channel_is_the_channel(void) {
    start();
    fc_channel_handle handle;
    CHECK_INT(fc_resolve_channel(ctx, "c", &handle), FC_OK);
    CHECK_INT(listed(), 0);
    CHECK_INT(get(&handle), 0);
    CHECK_INT(fc_channel_put_at(&handle, "ab", 2), FC_OK);
    fc_channel_put(ctx, "c", "c", 1);
    CHECK_INT(fc_channel_depth_at(&handle, ""), 2);
    CHECK_INT(get(&handle), 'a');
    fc_channel_add_corruption(ctx, "c", 0, 0);
    CHECK_INT(get(&handle), 'c' ^ 1);
    CHECK_INT(fc_channel_depth(ctx, "c", ""), 0);
    CHECK_INT(fc_channel_depth_at(&handle, "nobody"), FC_E_RECEIVER);
    CHECK_ERROR(FC_E_RECEIVER, "channel \"c\"");
    char data[1];
    CHECK_INT(fc_channel_get_at(&handle, "nobody", data, 1, NULL), FC_E_RECEIVER);
    CHECK_ERROR(FC_E_RECEIVER, "channel \"c\"");
    fc_channel_put_at(&handle, "ab", 2);
    size_t len = 0;
    CHECK_INT(fc_channel_get_at(&handle, "", data, 1, &len), FC_E_SPACE);
    CHECK_INT(len, 2);
    CHECK_ERROR(FC_E_SPACE, "channel \"c\"");
    finish();
}

static void a_channel_is_idle_with_nothing_armed_and_nothing_queued(void) {
    start();
    fc_channel_handle handle;
    fc_resolve_channel(ctx, "c", &handle);
    CHECK(fc_channel_is_idle(&handle));
    fc_channel_put_at(&handle, "a", 1);
    CHECK(!fc_channel_is_idle(&handle));
    get(&handle);
    CHECK(fc_channel_is_idle(&handle));
    fc_fault_id fault = fc_channel_add_delay(ctx, "c", 2);
    CHECK(!fc_channel_is_idle(&handle));
    fc_channel_put_at(&handle, "b", 1);
    fc_remove(ctx, fault);
    CHECK_INT(get(&handle), 0); /* still hidden */
    CHECK(!fc_channel_is_idle(&handle));
    fc_channel_clear(ctx, "c");
    CHECK(fc_channel_is_idle(&handle));
    fc_channel_subscribe(ctx, "c", "r");
    fc_channel_subscribe(ctx, "c", "s");
    CHECK(fc_channel_is_idle(&handle));
    fc_channel_put_at(&handle, "d", 1);
    char data[1];
    CHECK_INT(fc_channel_get_at(&handle, "s", data, 1, NULL), 1);
    CHECK(!fc_channel_is_idle(&handle)); /* r has not taken it */
    CHECK_INT(fc_channel_get_at(&handle, "r", data, 1, NULL), 1);
    CHECK(fc_channel_is_idle(&handle));
    fc_channel_put_at(&handle, "e", 1);
    fc_channel_add_lose(ctx, "c");
    fc_reset(ctx);
    CHECK(fc_channel_is_idle(&handle));
    finish();
}

static void packets_that_come_and_go_by_faults_of_others_are_noticed(void) {
    start();
    fc_channel_handle from, to;
    fc_resolve_channel(ctx, "from", &from);
    fc_resolve_channel(ctx, "to", &to);
    fc_fault_id fault = fc_channel_add_misroute(ctx, "from", "to");
    fc_channel_put_at(&from, "a", 1);
    CHECK(!fc_channel_is_idle(&to));
    fc_remove(ctx, fault);
    CHECK(fc_channel_is_idle(&from));
    fault = fc_channel_add_masquerade(ctx, "from", "to");
    CHECK_INT(get(&from), 'a');
    CHECK(fc_channel_is_idle(&to));
    CHECK(!fc_channel_is_idle(&from));
    fc_channel_remove_all_faults(ctx);
    CHECK(fc_channel_is_idle(&from));
    finish();
}

static void counted_and_recorded_channels_are_not_idle(void) {
    start();
    fc_channel_handle early, late;
    fc_resolve_channel(ctx, "early", &early);
    fc_record_start(ctx, NULL);
    fc_resolve_channel(ctx, "late", &late);
    CHECK(!fc_channel_is_idle(&early));
    CHECK(!fc_channel_is_idle(&late));
    fc_count_calls(ctx, true);
    fc_record_stop(ctx);
    CHECK(!fc_channel_is_idle(&early));
    fc_count_calls(ctx, false);
    CHECK(fc_channel_is_idle(&early));
    CHECK(fc_channel_is_idle(&late));
    finish();
}

int main(void) {
    a_resolved_probe_is_that_of_its_context();
    a_handle_survives_a_reset_and_other_names();
    idle_tells_whether_a_call_does_anything();
    every_type_can_be_resolved();
    what_cannot_be_resolved_is_refused();
    a_resolved_channel_is_the_channel();
    a_channel_is_idle_with_nothing_armed_and_nothing_queued();
    packets_that_come_and_go_by_faults_of_others_are_noticed();
    counted_and_recorded_channels_are_not_idle();
    return CHECK_RESULT();
}
