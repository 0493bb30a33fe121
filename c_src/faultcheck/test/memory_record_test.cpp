// An allocation that fails while values are recorded or listed, and while recordings are read.
#include "failing_new.h"

#include <vector>

namespace {

const char *const kId = "a long identifier, longer than any short string";
const char kPacket[] = "a packet that is longer than any short string";
constexpr auto nothing = [](fc_context *) {};

int probe(fc_context *ctx) {
    int32_t value = 5;
    const int result = fc_probe_i32(ctx, kId, &value);
    CHECK(result != FC_E_NOMEM || value == 5);
    return result;
}

void count_line(void *user, const char *) {
    ++*static_cast<int *>(user);
}

std::string recording_of(fc_context *ctx) {
    std::string data(fc_record_copy(ctx, nullptr, 0), '\0');
    fc_record_copy(ctx, data.data(), data.size());
    return data;
}

int calls_in(const std::string &recording) {
    int lines = 0;
    CHECK_INT(fc_record_text(recording.data(), recording.size(), count_line, &lines), FC_OK);
    return lines;
}

void starting_a_recording() {
    const int failed = fail_each(
        nothing, [](fc_context *ctx) { return fc_record_start(ctx, nullptr); },
        [](fc_context *ctx) {
            CHECK_INT(fc_record_copy(ctx, nullptr, 0), 0);
            CHECK_INT(fc_record_stop(ctx), FC_OK);
        });
    CHECK(failed > 0);
}

// The one that is under way goes on.
void starting_another_recording() {
    fc_context *ctx = fc_new(nullptr);
    errors_start(ctx);
    fc_record_start(ctx, nullptr);
    probe(ctx);
    const std::string before = recording_of(ctx);
    CHECK_INT(fc_record_start(ctx, "/nowhere/at/all"), FC_E_IO);
    CHECK_ERROR(FC_E_IO, "/nowhere/at/all");
    CHECK(recording_of(ctx) == before);
    CHECK_INT(fc_record_stop(ctx), FC_OK);
    fc_free(ctx);
}

// A file that was opened is closed again: the descriptor of the next one is the same.
void starting_a_recording_to_a_file() {
    fc_context *ctx = fc_new(nullptr);
    errors_start(ctx);
    for (int round = 0; round < 3; ++round) {
        fail_at = 0;
        CHECK_INT(fc_record_start(ctx, "/dev/null"), FC_E_NOMEM);
        fail_at = -1;
        CHECK_ERROR(FC_E_NOMEM, "/dev/null");
    }
    CHECK_INT(fc_record_start(ctx, "/dev/null"), FC_OK);
    probe(ctx);
    CHECK_INT(fc_record_stop(ctx), FC_OK);
    fc_free(ctx);
}

// The probe goes through; stopping tells that the recording has a gap.
void a_value_that_does_not_fit() {
    fc_context *ctx = fc_new(nullptr);
    errors_start(ctx);
    CHECK_INT(fc_record_start(ctx, nullptr), FC_OK);
    std::vector<char> packet(100000, 'x');
    int put = 0;
    int lost = 0;
    fc_add_offset(ctx, kId, 1);
    while (lost == 0) {
        const std::size_t before = fc_record_copy(ctx, nullptr, 0);
        fail_at = 0;
        CHECK_INT(fc_monitor_bytes(ctx, kId, packet.data(), packet.size()), FC_OK);
        lost += fail_at < 0;
        fail_at = -1;
        put += fc_record_copy(ctx, nullptr, 0) > before;
    }
    CHECK_INT(probe(ctx), FC_OK);
    CHECK_NO_ERROR();
    CHECK_INT(fc_record_stop(ctx), FC_E_NOMEM);
    CHECK_ERROR(FC_E_NOMEM, "does not fit the memory");
    CHECK_INT(calls_in(recording_of(ctx)), put + 1);
    CHECK_INT(fc_record_stop(ctx), FC_OK);
    fc_free(ctx);
}

// A call that has no effect is not recorded either.
template <class Work> void what_fails_is_not_recorded(Work work) {
    std::string before;
    const int failed = fail_each(
        [&](fc_context *ctx) {
            fc_record_start(ctx, nullptr);
            fc_monitor_u8(ctx, "first", 1);
            before = recording_of(ctx);
        },
        work, [&](fc_context *ctx) { CHECK(recording_of(ctx) == before); });
    CHECK(failed > 0);
}

void calls_that_are_recorded() {
    what_fails_is_not_recorded(probe);
    what_fails_is_not_recorded([](fc_context *ctx) { return fc_monitor_i32(ctx, kId, 5); });
    what_fails_is_not_recorded([](fc_context *ctx) {
        char data[sizeof kPacket];
        memcpy(data, kPacket, sizeof data);
        return fc_probe_bytes(ctx, kId, data, sizeof data);
    });
    what_fails_is_not_recorded(
        [](fc_context *ctx) { return fc_channel_put(ctx, kId, kPacket, sizeof kPacket); });
}

void arm_everything(fc_context *ctx) {
    fc_add_offset(ctx, kId, 1);
    probe(ctx);
    fc_channel_subscribe(ctx, kId, kPacket);
    fc_channel_add_drop(ctx, kId, 1);
    fc_channel_put(ctx, kId, kPacket, sizeof kPacket);
}

void listing() {
    const auto visit = [](void *user, const fc_listed *) { ++*static_cast<int *>(user); };
    CHECK(fail_each(
              arm_everything,
              [&](fc_context *ctx) {
                  int seen = 0;
                  const int result = fc_list(ctx, visit, &seen);
                  CHECK_INT(seen, result == FC_OK ? 2 : 0);
                  return result;
              },
              nothing) > 0);
}

void listing_without_a_function() {
    CHECK(fail_each(
              arm_everything,
              [](fc_context *ctx) -> int {
                  fc_listing *made = fc_listing_new(ctx);
                  const bool good = made != nullptr;
                  fc_listing_free(made);
                  return good ? FC_OK : FC_E_NOMEM;
              },
              nothing) > 0);
}

void dumping() {
    CHECK(fail_each(
              arm_everything,
              [](fc_context *ctx) {
                  int lines = 0;
                  const int result = fc_dump_json(ctx, count_line, &lines);
                  CHECK(lines == 2 || (result != FC_OK && lines < 2));
                  return result;
              },
              nothing) > 0);
}

std::string some_recording(int values) {
    fc_context *ctx = fc_new(nullptr);
    fc_record_start(ctx, nullptr);
    arm_everything(ctx);
    for (int value = 0; value < values; ++value)
        fc_monitor_f64(ctx, kPacket, value / 4.0);
    std::string recording = recording_of(ctx);
    fc_free(ctx);
    return recording;
}

// These report to the default context.
template <class Work> void reading(Work work) {
    errors_start(nullptr);
    const auto in_default = [&](fc_context *) { return work(); };
    const std::string unchanged = listing_of(nullptr);
    CHECK(fail_each(nothing, in_default, nothing) > 0);
    CHECK(listing_of(nullptr) == unchanged);
}

void reading_recordings() {
    const std::string golden = some_recording(5);
    const std::string run = some_recording(7);
    reading([&] {
        int lines = 0;
        const int result = fc_record_text(run.data(), run.size(), count_line, &lines);
        CHECK(lines == 9 || (result != FC_OK && lines < 9));
        return result;
    });
    reading([&]() -> int {
        fc_comparison *made =
            fc_comparison_new(golden.data(), golden.size(), run.data(), run.size(), nullptr);
        const bool good = made != nullptr;
        fc_comparison_free(made);
        return good ? FC_OK : FC_E_NOMEM;
    });
    const auto visit = [](void *user, const fc_divergence *found) {
        CHECK_INT(found->extra, 2);
        ++*static_cast<int *>(user);
    };
    reading([&] {
        int found = 0;
        const int result = fc_compare(golden.data(), golden.size(), run.data(), run.size(), nullptr,
                                      visit, &found);
        CHECK_INT(found, result == FC_E_NOMEM ? 0 : 1);
        return result;
    });
}

} // namespace

int main() {
    fc_default();
    starting_a_recording();
    starting_another_recording();
    starting_a_recording_to_a_file();
    a_value_that_does_not_fit();
    calls_that_are_recorded();
    listing();
    listing_without_a_function();
    dumping();
    reading_recordings();
    return CHECK_RESULT();
}
