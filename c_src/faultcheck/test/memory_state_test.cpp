// An allocation that fails in a call that changes much: a probe whose faults keep values, each way
// of arming, changes of faults. FC_E_NOMEM, and neither value nor faults nor queues have changed.
#include "failing_new.h"

namespace {

const char *const kId = "a long identifier, longer than any short string";
const char kPacket[] = "a packet that is longer than any short string";
constexpr auto nothing = [](fc_context *) {};

fc_fault_id add(fc_context *ctx, int kind, double a, double b, int64_t n) {
    const fc_model model = {kind, a, b, n};
    return fc_add_model(ctx, kId, &model);
}

// Every model that keeps values, behind one that does not and in front of one.
void arm_all(fc_context *ctx) {
    fc_trigger_duration(ctx, fc_add_offset(ctx, kId, 1), 5);
    add(ctx, FC_STUCK, 0, 0, 0);
    add(ctx, FC_RAMP, 9, 0, 3);
    fc_trigger_after(ctx, add(ctx, FC_DELAY, 0, 0, 2), 1);
    add(ctx, FC_DROPOUT, 0.5, 0, FC_HOLD);
    add(ctx, FC_BITFLIP_RANDOM, 0, 0, 0);
}

// Results of a probe on its way through the faults depend on all that came before.
template <class Probe> void a_probe_with_memory(Probe probe) {
    for (int before = 0; before < 4; ++before) {
        const int failed = fail_each(
            [&](fc_context *ctx) {
                arm_all(ctx);
                for (int call = 0; call < before; ++call)
                    probe(ctx);
            },
            probe, nothing);
        CHECK(before > 0 || failed > 0);
    }
}

int probe_number(fc_context *ctx) {
    int32_t value = 5;
    const int result = fc_probe_i32(ctx, kId, &value);
    CHECK(result != FC_E_NOMEM || value == 5);
    return result;
}

void a_probe_of_numbers() {
    a_probe_with_memory(probe_number);
}

void a_probe_of_bytes() {
    for (int before = 0; before < 4; ++before) {
        const auto probe = [](fc_context *ctx) {
            char data[sizeof kPacket];
            memcpy(data, kPacket, sizeof data);
            const int result = fc_probe_bytes(ctx, kId, data, sizeof data);
            CHECK(result != FC_E_NOMEM || memcmp(data, kPacket, sizeof data) == 0);
            return result;
        };
        const int failed = fail_each(
            [&](fc_context *ctx) {
                fc_trigger_duration(ctx, add(ctx, FC_BITFLIP, 0, 0, 0), 5);
                add(ctx, FC_STUCK, 0, 0, 0);
                add(ctx, FC_DELAY, 0, 0, 2);
                for (int call = 0; call < before; ++call)
                    probe(ctx);
            },
            probe, nothing);
        CHECK(before > 2 || failed > 0); // in the end buffers change places
    }
}

void a_probe_of_several_types() {
    fail_each(
        [](fc_context *ctx) {
            arm_all(ctx);
            probe_number(ctx);
        },
        [](fc_context *ctx) {
            double value = 2.5;
            const int result = fc_probe_f64(ctx, kId, &value);
            CHECK(result != FC_E_NOMEM || value == 2.5);
            return result;
        },
        nothing);
}

// More than any memory could hold: nothing of it is read.
void a_length_that_cannot_be() {
    fc_context *ctx = fc_new(nullptr);
    errors_start(ctx);
    fc_channel_add_drop(ctx, kId, 0);
    add(ctx, FC_STUCK, 0, 0, 0);
    char data[] = "data";
    for (const std::size_t length : {SIZE_MAX, SIZE_MAX / 2, SIZE_MAX / 4}) {
        CHECK_INT(fc_probe_bytes(ctx, kId, data, length), FC_E_NOMEM);
        CHECK_ERROR(FC_E_NOMEM, "memory");
        CHECK_INT(fc_channel_put(ctx, kId, data, length), FC_E_NOMEM);
        CHECK_ERROR(FC_E_NOMEM, "memory");
        CHECK_INT(fc_channel_add_insert(ctx, kId, data, length, 1), FC_E_NOMEM);
        CHECK_ERROR(FC_E_NOMEM, "memory");
    }
    CHECK_INT(fc_channel_depth(ctx, kId, ""), 0);
    fc_free(ctx);
}

// The error is told as what it is; only its text is lost.
void a_skipped_fault_that_cannot_be_reported() {
    fc_context *ctx = fc_new(nullptr);
    errors_start(ctx);
    fc_add_bitflip(ctx, kId, 40);
    probe_number(ctx);
    errors_seen = 0;
    fail_at = 0;
    CHECK_INT(probe_number(ctx), FC_E_BIT);
    CHECK(fail_at < 0);
    CHECK_ERROR(FC_E_NOMEM, "out of memory while reporting 1");
    CHECK_INT(probe_number(ctx), FC_E_BIT);
    fc_free(ctx);
}

bool holds(void *) {
    return true;
}

int64_t noon(void *) {
    return 12;
}

void a_probe_with_predicates() {
    const int failed = fail_each(
        [](fc_context *ctx) {
            fc_trigger_when(ctx, fc_add_offset(ctx, kId, 1), holds, nullptr);
            fc_trigger_time(ctx, fc_add_offset(ctx, kId, 1), 0, 1000);
            fc_advance(ctx, 0);
        },
        probe_number, nothing);
    CHECK(failed > 0);
}

void a_clock_of_the_user() {
    const int failed = fail_each([](fc_context *ctx) { fc_advance(ctx, 77); },
                                 [](fc_context *ctx) -> int {
                                     const uint64_t errors = fc_error_count(ctx);
                                     fc_set_clock(ctx, noon, nullptr);
                                     return fc_error_count(ctx) == errors ? FC_OK : FC_E_NOMEM;
                                 },
                                 [](fc_context *ctx) { CHECK_INT(fc_now(ctx), 77); });
    CHECK(failed > 0);
}

template <class Arm> void arming(Arm arm) {
    fail_each(nothing, arm, [](fc_context *ctx) {
        CHECK_INT(fc_channel_latest(ctx, kId), FC_E_NO_FAULT);
        CHECK_INT(fc_latest(ctx, kId), FC_E_NO_FAULT);
        errors_seen = 0;
    });
}

void each_way_of_arming() {
    static const char *const receivers[] = {kId, kPacket};
    static const fc_field field = {0, FC_U16, true, 0};
    static const fc_model model = {FC_OFFSET, 1, 0, 0};
    arming([](fc_context *ctx) { return fc_add_model(ctx, kId, &model); });
    arming([](fc_context *ctx) { return fc_channel_add_corruption(ctx, kId, 0, 1); });
    arming([](fc_context *ctx) { return fc_channel_add_field(ctx, kId, &field, &model); });
    arming([](fc_context *ctx) { return fc_channel_add_truncate(ctx, kId, 1); });
    arming([](fc_context *ctx) { return fc_channel_add_extend(ctx, kId, 1, 'x'); });
    arming([](fc_context *ctx) { return fc_channel_add_drop(ctx, kId, 1); });
    arming([](fc_context *ctx) { return fc_channel_add_repeat(ctx, kId, 1); });
    arming([](fc_context *ctx) { return fc_channel_add_lose(ctx, kId); });
    arming([](fc_context *ctx) { return fc_channel_add_repeat_last(ctx, kId); });
    arming([](fc_context *ctx) {
        return fc_channel_add_insert(ctx, kId, kPacket, sizeof kPacket, 1);
    });
    arming([](fc_context *ctx) { return fc_channel_add_masquerade(ctx, kId, kPacket); });
    arming([](fc_context *ctx) { return fc_channel_add_resequence(ctx, kId, 1); });
    arming([](fc_context *ctx) { return fc_channel_add_block_get(ctx, kId); });
    arming([](fc_context *ctx) { return fc_channel_add_delay(ctx, kId, 1); });
    arming([](fc_context *ctx) { return fc_channel_add_delay_time(ctx, kId, 1); });
    arming([](fc_context *ctx) { return fc_channel_add_misroute(ctx, kId, kPacket); });
    arming([](fc_context *ctx) {
        return fc_channel_add_asymmetric(ctx, kId, receivers, 2, &field, &model);
    });
    arming([](fc_context *ctx) { return fc_channel_add_subset(ctx, kId, receivers, 2); });
    arming([](fc_context *ctx) { return fc_channel_add_block_put(ctx, kId); });
}

void one_receiver_only() {
    fc_fault_id fault = 0;
    const int failed = fail_each(
        [&](fc_context *ctx) { fault = fc_channel_add_drop(ctx, kId, 1); },
        [&](fc_context *ctx) { return fc_channel_fault_receiver(ctx, fault, kPacket); }, nothing);
    CHECK(failed > 0);
}

int put(fc_context *ctx) {
    return fc_channel_put(ctx, kId, kPacket, sizeof kPacket);
}

void a_put_through_faults() {
    static const char *const receivers[] = {"r", "s"};
    static const fc_model model = {FC_STUCK, 0, 0, 0};
    const auto depths = [](fc_context *ctx) {
        CHECK_INT(fc_channel_depth(ctx, kId, "r"), 1);
        CHECK_INT(fc_channel_depth(ctx, kId, "s"), 1);
    };
    const int failed = fail_each(
        [](fc_context *ctx) {
            fc_channel_subscribe(ctx, kId, "r");
            fc_channel_subscribe(ctx, kId, "s");
            fc_channel_subscribe(ctx, kId, "t");
            fc_trigger_duration(
                ctx, fc_channel_add_asymmetric(ctx, kId, receivers, 2, nullptr, &model), 3);
            fc_channel_add_subset(ctx, kId, receivers, 2);
            fc_channel_add_delay(ctx, kId, 1);
            put(ctx);
        },
        put, depths);
    CHECK(failed > 0);
    fail_each([](fc_context *ctx) { fc_channel_add_misroute(ctx, kId, "elsewhere"); }, put,
              [](fc_context *ctx) { CHECK_INT(fc_channel_depth(ctx, "elsewhere", ""), 0); });
}

// Gets whose faults take packets of another channel, or out of turn.
void a_get_from_elsewhere() {
    static const fc_field field = {0, FC_U16, true, 0};
    static const fc_model model = {FC_DELAY, 0, 0, 2};
    const auto get = [](fc_context *ctx) {
        char data[100];
        return fc_channel_get(ctx, kId, "", data, sizeof data, nullptr);
    };
    const int failed = fail_each(
        [&](fc_context *ctx) {
            for (int packet = 0; packet < 4; ++packet)
                put(ctx);
            fc_channel_put(ctx, "other", kPacket, sizeof kPacket);
            fc_trigger_periodic(ctx, fc_channel_add_field(ctx, kId, &field, &model), 2, 1);
            fc_channel_add_repeat(ctx, kId, 2);
            fc_channel_add_resequence(ctx, kId, 2);
            fc_channel_add_masquerade(ctx, kId, "other");
            fc_channel_add_insert(ctx, kId, kPacket, sizeof kPacket, 1);
            fc_channel_add_extend(ctx, kId, 40, 'x');
            fc_channel_add_repeat_last(ctx, kId);
        },
        get,
        [](fc_context *ctx) {
            CHECK_INT(fc_channel_depth(ctx, kId, ""), 4);
            CHECK_INT(fc_channel_depth(ctx, "other", ""), 1);
        });
    CHECK(failed > 0);
}

void keeping_and_putting_back() {
    fc_snapshot *kept = nullptr;
    const auto prepare = [&](fc_context *ctx) {
        arm_all(ctx);
        probe_number(ctx);
        put(ctx);
    };
    CHECK(fail_each(
              prepare,
              [&](fc_context *ctx) -> int {
                  kept = fc_save(ctx);
                  const bool good = kept != nullptr;
                  fc_release(kept);
                  kept = nullptr;
                  return good ? FC_OK : FC_E_NOMEM;
              },
              nothing) > 0);
    CHECK(fail_each(
              [&](fc_context *ctx) {
                  fc_release(kept);
                  prepare(ctx);
                  kept = fc_save(ctx);
                  probe_number(ctx);
                  put(ctx);
              },
              [&](fc_context *ctx) { return fc_restore(ctx, kept); },
              [](fc_context *ctx) { CHECK_INT(fc_channel_depth(ctx, kId, ""), 2); }) > 0);
    fc_release(kept);
}

} // namespace

int main() {
    fc_default();
    a_probe_of_numbers();
    a_probe_of_bytes();
    a_probe_of_several_types();
    a_length_that_cannot_be();
    a_skipped_fault_that_cannot_be_reported();
    a_probe_with_predicates();
    a_clock_of_the_user();
    each_way_of_arming();
    one_receiver_only();
    a_put_through_faults();
    a_get_from_elsewhere();
    keeping_and_putting_back();
    return CHECK_RESULT();
}
