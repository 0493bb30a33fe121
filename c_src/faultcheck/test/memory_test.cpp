// An allocation that fails: FC_E_NOMEM, and nothing has changed. Idle probes allocate nothing.
#include "failing_new.h"

namespace {

constexpr auto nothing = [](fc_context *) {};

int32_t probe(fc_context *ctx) {
    int32_t value = 0;
    fc_probe_i32(ctx, "a long identifier, longer than any short string", &value);
    return value;
}

const char *const kId = "a long identifier, longer than any short string";
const char kPacket[] = "a packet that is longer than any short string";

void adding_a_fault() {
    const int failed = fail_each(
        nothing, [](fc_context *ctx) { return fc_add_offset(ctx, kId, 1); }, nothing);
    CHECK(failed > 0);
    fail_each([](fc_context *ctx) { fc_add_offset(ctx, kId, 10); },
              [](fc_context *ctx) { return fc_add_offset(ctx, kId, 1); }, nothing);
}

void the_first_probe() {
    const int failed = fail_each(
        nothing,
        [](fc_context *ctx) {
            int32_t value = 5;
            const int result = fc_probe_i32(ctx, kId, &value);
            CHECK_INT(value, 5);
            return result;
        },
        nothing);
    CHECK(failed > 0);
}

void a_put() {
    const int failed = fail_each(
        nothing, [](fc_context *ctx) { return fc_channel_put(ctx, kId, kPacket, sizeof kPacket); },
        [](fc_context *ctx) { CHECK_INT(fc_channel_depth(ctx, kId, ""), 0); });
    CHECK(failed > 0);
}

void a_get_through_faults() {
    const int failed = fail_each(
        [](fc_context *ctx) {
            fc_channel_add_drop(ctx, kId, 1);
            fc_channel_add_corruption(ctx, kId, 0, 0);
            fc_channel_add_repeat(ctx, kId, 2);
            fc_channel_put(ctx, kId, "dropped", 7);
            fc_channel_put(ctx, kId, kPacket, sizeof kPacket);
        },
        [](fc_context *ctx) {
            char data[100];
            size_t len;
            const int result = fc_channel_get(ctx, kId, "", data, sizeof data, &len);
            CHECK(result != 1 || (len == sizeof kPacket && data[0] == (kPacket[0] ^ 1)));
            return result;
        },
        [](fc_context *ctx) { CHECK_INT(fc_channel_depth(ctx, kId, ""), 2); });
    CHECK(failed > 0);
}

void a_subscription() {
    const int failed =
        fail_each([](fc_context *ctx) { fc_channel_add_drop(ctx, kId, 1); },
                  [](fc_context *ctx) { return fc_channel_subscribe(ctx, kId, kPacket); },
                  [](fc_context *ctx) {
                      CHECK_INT(fc_channel_depth(ctx, kId, kPacket), FC_E_RECEIVER);
                      errors_seen = 0;
                  });
    CHECK(failed > 0);
}

void resolving() {
    const int failed = fail_each(
        nothing,
        [](fc_context *ctx) {
            fc_handle handle = {nullptr, nullptr, nullptr};
            const int result = fc_resolve(ctx, kId, FC_I32, &handle);
            CHECK((result == FC_OK) == (handle.probe != nullptr));
            return result;
        },
        nothing);
    CHECK(failed > 0);
    CHECK(fail_each(
              nothing,
              [](fc_context *ctx) {
                  fc_channel_handle handle = {nullptr, nullptr, nullptr};
                  const int result = fc_resolve_channel(ctx, kId, &handle);
                  CHECK((result == FC_OK) == (handle.channel != nullptr));
                  return result;
              },
              nothing) > 0);
}

void arm_and_queue(fc_context *ctx) {
    fc_add_offset(ctx, kId, 1);
    fc_add_delay(ctx, kId, 3);
    probe(ctx);
    fc_channel_add_repeat(ctx, kId, 2);
    fc_channel_put(ctx, kId, kPacket, sizeof kPacket);
}

void a_snapshot() {
    const int failed = fail_each(
        arm_and_queue,
        [](fc_context *ctx) {
            fc_snapshot *snapshot = fc_save(ctx);
            fc_release(snapshot);
            return snapshot != nullptr ? FC_OK : FC_E_NOMEM;
        },
        [](fc_context *ctx) { CHECK_INT(fc_channel_depth(ctx, kId, ""), 1); });
    CHECK(failed > 0);
}

void a_restored_snapshot() {
    static fc_snapshot *snapshot;
    const int failed = fail_each(
        [](fc_context *ctx) {
            arm_and_queue(ctx);
            fc_release(snapshot);
            snapshot = fc_save(ctx);
            fc_remove_all_probe_faults(ctx);
            fc_add_offset(ctx, kId, 10);
            fc_channel_clear(ctx, kId);
        },
        [](fc_context *ctx) {
            const int result = fc_restore(ctx, snapshot);
            CHECK_INT(fc_channel_depth(ctx, kId, ""), result == FC_OK ? 1 : 0);
            return result;
        },
        [](fc_context *ctx) { CHECK_INT(probe(ctx), 10); });
    CHECK(failed > 0);
    fc_release(snapshot);
}

void a_new_context() {
    errors_start(nullptr);
    for (int failing = 0; failing < 4; ++failing) {
        fail_at = failing;
        fc_context *ctx = fc_new(nullptr);
        if (fail_at < 0) {
            CHECK(ctx == nullptr);
            CHECK_ERROR(FC_E_NOMEM, "memory");
        }
        fail_at = -1;
        fc_free(ctx);
    }
}

void quiet_calls_allocate_nothing() {
    fc_context *ctx = fc_new(nullptr);
    fc_add_offset(ctx, "armed", 1);
    char data[100];
    size_t len;
    long before = 0;
    for (int round = 0; round < 100; ++round) {
        if (round == 50)
            before = allocations;
        probe(ctx);
        int32_t value = 0;
        fc_probe_i32(ctx, "armed", &value);
        fc_channel_put(ctx, "c", kPacket, sizeof kPacket);
        fc_channel_get(ctx, "c", "", data, sizeof data, &len);
    }
    CHECK_INT(allocations, before);
    fc_free(ctx);
}

} // namespace

int main() {
    fc_default();
    adding_a_fault();
    the_first_probe();
    a_put();
    a_get_through_faults();
    a_subscription();
    resolving();
    a_snapshot();
    a_restored_snapshot();
    a_new_context();
    quiet_calls_allocate_nothing();
    return CHECK_RESULT();
}
