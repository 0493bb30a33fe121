// Several threads at once (7.4 of the reference). Meant for ThreadSanitizer as well.
#include "check.h"
#include "fc.h"

#include <atomic>
#include <string>
#include <thread>
#include <vector>

namespace {

constexpr int kRounds = 3000;

// Each affected call adds one, so the sum tells whether a call was lost or counted twice.
void calls_of_one_identifier_are_atomic(fc_context *ctx) {
    fc_trigger_duration(ctx, fc_add_offset(ctx, "shared", 1), 2 * kRounds);
    std::atomic<int> affected{0};
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 4; ++thread)
        threads.emplace_back([&] {
            for (int round = 0; round < kRounds; ++round) {
                int32_t value = 0;
                fc_probe_i32(ctx, "shared", &value);
                affected += value;
            }
        });
    for (std::thread &thread : threads)
        thread.join();
    CHECK_INT(affected, 2 * kRounds);
}

void arming_and_probing_at_once(fc_context *ctx) {
    std::atomic<bool> stop{false};
    std::thread prober([&] {
        while (!stop) {
            int32_t value = 0;
            double other = 0;
            fc_probe_i32(ctx, "armed", &value);
            CHECK(value == 0 || value == 8);
            fc_probe_f64(ctx, "idle", &other);
            CHECK_BITS(other, 0);
        }
    });
    for (int round = 0; round < kRounds; ++round) {
        const fc_fault_id fault = fc_add_bitflip(ctx, "armed", 3);
        int32_t value = 0;
        fc_probe_i32(ctx, "armed", &value);
        CHECK_INT(value, 8);
        fc_trigger_after(ctx, fault, 1);
        fc_num_active(ctx, "armed");
        fc_remove(ctx, fault);
    }
    stop = true;
    prober.join();
}

// Readers walk the table while it grows several times.
void new_identifiers_from_all_threads(fc_context *ctx) {
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 3; ++thread)
        threads.emplace_back([&, thread] {
            for (int round = 0; round < 600; ++round) {
                const std::string id = "id" + std::to_string((round * (thread + 1)) % 600);
                int64_t value = round;
                fc_probe_i64(ctx, id.c_str(), &value);
                CHECK_INT(value, round);
            }
        });
    for (std::thread &thread : threads)
        thread.join();
}

void a_channel_loses_no_packet(fc_context *ctx) {
    std::atomic<int> received{0};
    std::thread sender([&] {
        for (int round = 0; round < kRounds; ++round)
            fc_channel_put(ctx, "c", &round, sizeof round);
    });
    std::thread rearmer([&] {
        for (int round = 0; round < 200; ++round) {
            const fc_fault_id fault = fc_channel_add_corruption(ctx, "c", 0, 0);
            fc_channel_depth(ctx, "c", "");
            fc_remove(ctx, fault);
        }
    });
    std::thread receiver([&] {
        while (received < kRounds) {
            int packet;
            size_t len = 0;
            if (fc_channel_get(ctx, "c", "", &packet, sizeof packet, &len) == 1) {
                CHECK_INT(packet / 2, received / 2); /* bit 0 may be flipped */
                ++received;
            } else {
                std::this_thread::yield();
            }
        }
    });
    sender.join();
    rearmer.join();
    receiver.join();
    CHECK_INT(fc_channel_depth(ctx, "c", ""), 0);
}

// What a snapshot holds is whole: the fault adds 1 or, between a restore and the next removal, 2.
void saving_and_restoring_while_others_probe(fc_context *ctx) {
    fc_add_offset(ctx, "saved", 1);
    fc_snapshot *one = fc_save(ctx);
    fc_add_offset(ctx, "saved", 1);
    fc_snapshot *two = fc_save(ctx);
    std::atomic<bool> stop{false};
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 2; ++thread)
        threads.emplace_back([&] {
            fc_handle handle;
            fc_channel_handle channel;
            CHECK_INT(fc_resolve(ctx, "saved", FC_I32, &handle), FC_OK);
            CHECK_INT(fc_resolve_channel(ctx, "queue", &channel), FC_OK);
            while (!stop) {
                int32_t value = 0;
                fc_probe_i32_at(&handle, &value);
                CHECK(value == 1 || value == 2);
                if (fc_channel_is_idle(&channel))
                    fc_channel_put_at(&channel, "p", 1);
                char packet;
                fc_channel_get_at(&channel, "", &packet, 1, nullptr);
            }
        });
    for (int round = 0; round < 500; ++round) {
        CHECK_INT(fc_restore(ctx, round % 2 == 0 ? one : two), FC_OK);
        fc_release(fc_save(ctx));
    }
    stop = true;
    for (std::thread &thread : threads)
        thread.join();
    fc_release(one);
    fc_release(two);
    fc_remove_all_probe_faults(ctx);
}

void last_errors_are_per_thread(fc_context *ctx) {
    fc_clear_last_error();
    std::thread([&] {
        fc_add_bitflip(ctx, "p", -1);
        CHECK_INT(fc_last_error(), FC_E_BIT);
    }).join();
    CHECK_INT(fc_last_error(), FC_OK);
    CHECK_INT(fc_error_count(ctx), 1);
}

void ignore(void *, const fc_error *) {}

} // namespace

int main() {
    fc_context *ctx = fc_new(nullptr);
    fc_set_error_callback(ctx, ignore, nullptr);
    calls_of_one_identifier_are_atomic(ctx);
    arming_and_probing_at_once(ctx);
    new_identifiers_from_all_threads(ctx);
    a_channel_loses_no_packet(ctx);
    saving_and_restoring_while_others_probe(ctx);
    last_errors_are_per_thread(ctx);
    fc_free(ctx);
    return CHECK_RESULT();
}
