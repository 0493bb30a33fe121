// The record of one probe identifier.
#pragma once

#include "fault.h"
#include "name.h"
#include "recorder.h"
#include "spin_lock.h"
#include "value.h"

#include <atomic>
#include <cstdint>
#include <vector>

namespace fc {

// What faults have made of a probe: a snapshot copies it.
struct ProbeContent {
    // Under the probe's lock; faults are added and removed under the context's arming lock as well.
    std::uint64_t calls = 0;        // while armed or watched
    std::vector<ProbeFault> faults; // in the order of adding
    bool wants_inputs = false;      // a fault asks for the time or a predicate
    bool has_memory = false;        // a fault's model keeps values
    bool is_plain = true;           // neither

    // Under the context's arming lock.
    bool latest_refused = false;
    std::uint64_t next_ordinal = 0;

    // As it was made.
    bool is_new() const {
        return faults.empty() && calls == 0 && next_ordinal == 0 && !latest_refused;
    }
};

// A record of its own cache lines: arming one identifier does not slow the idle probes of another.
struct alignas(64) Probe : ProbeContent {
    explicit Probe(const Name &identifier) : name(identifier) {
        set_states(kUnseen);
    }

    // Why a probe call of a type cannot return at once; 0 for an idle one. Written under the
    // context's arming lock.
    enum State : std::uint8_t {
        kUnseen = 1, // not yet probed as this type since fc_new or fc_reset
        kArmed = 2,
        kWatched = 4, // calls are recorded or counted
    };
    std::atomic<std::uint8_t> state[kTypeCount];

    StoredName name;

    SpinLock lock;
    bool watched = false; // calls are recorded or counted
    bool listed = false;  // seen or armed since fc_new or fc_reset; under the arming lock
    RecordedAs recorded_as;

    // Under lock and the arming lock.
    void reset() {
        static_cast<ProbeContent &>(*this) = ProbeContent();
        set_states(kUnseen);
        listed = watched = false;
    }

    // Under lock.
    void watch(bool on) {
        watched = on;
        if (on)
            set_flag(kWatched);
        else
            clear_flag(kWatched);
    }

    void set_states(std::uint8_t value) {
        for (auto &of_type : state)
            of_type.store(value, std::memory_order_relaxed);
    }
    void set_flag(State flag) {
        for (auto &of_type : state)
            of_type.fetch_or(flag, std::memory_order_relaxed);
    }
    void clear_flag(State flag) {
        for (auto &of_type : state)
            of_type.fetch_and(static_cast<std::uint8_t>(~flag), std::memory_order_relaxed);
    }
};

} // namespace fc
