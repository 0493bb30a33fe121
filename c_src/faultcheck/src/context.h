// A context: everything that faults, probes and channels share.
#pragma once

#include "channel.h"
#include "clock.h"
#include "name_table.h"
#include "probe.h"

#include <cstdint>
#include <mutex>
#include <new>
#include <stdexcept>
#include <unordered_map>

namespace fc {

struct ErrorCallback {
    fc_error_fn call;
    void *user;
};

// Where a fault id leads.
struct FaultPlace {
    Probe *probe;
    Channel *channel;
};

} // namespace fc

// Lock order: arming, then a probe's lock or the traffic lock. No callback runs under any of them.
struct fc_context {
    explicit fc_context(const fc_options &options);

    const std::uint64_t number; // no other context of the process ever has it
    fc::NameTable<fc::Probe> probes;
    fc::NameTable<fc::Channel> channels;
    std::atomic<std::uint64_t> error_count{0};
    fc::Clock clock;
    // Goes up with every change of what is armed, counted or recorded.
    std::atomic<std::uint64_t> change_count{0};
    fc::Recorder recorder;
    std::atomic<bool> recording{false};

    // Everything that arms, disarms or lists. Guards the tables' writers and the members below it.
    std::mutex arming;
    std::unordered_map<fc_fault_id, fc::FaultPlace> faults;
    fc_fault_id next_fault = 1;
    std::uint64_t seed;
    const std::uint64_t first_seed;
    bool counting = false; // fc_count_calls

    // All channels' queues and faults.
    fc::SpinLock traffic;

    fc::ErrorCallback error_callback() const;
    void set_error_callback(fc::ErrorCallback callback);

    // Under the arming lock.
    fc::Probe &probe(const fc::Name &name);
    fc::Channel &channel(const fc::Name &name);
    void reset();
    void reseed(std::uint64_t new_seed);
    // Calls are recorded or counted.
    bool watched() const;
    // After a change of that: lets every probe and channel know.
    void watch();
    void note_change() {
        change_count.fetch_add(1, std::memory_order_release);
    }

  private:
    mutable fc::SpinLock callback_lock_;
    fc::ErrorCallback on_error_;
};

namespace fc {

extern std::atomic<fc_context *> default_context;

inline fc_context &context_of(fc_context *ctx) {
    if (ctx != nullptr)
        return *ctx;
    ctx = default_context.load(std::memory_order_acquire);
    return ctx != nullptr ? *ctx : *fc_default();
}

// Runs work and turns an exhausted memory into FC_E_NOMEM. work holds no lock when it throws out of
// here.
template <class Work> auto guarded(fc_context &context, const Work &work) -> decltype(work()) {
    try {
        return work();
    } catch (const std::bad_alloc &) {
        return report_no_memory(context);
    } catch (const std::length_error &) { // more than any memory could hold
        return report_no_memory(context);
    }
}

} // namespace fc
