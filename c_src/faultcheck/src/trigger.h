// When a fault is active: the iteration window and the conditions beside it.
#pragma once

#include "fc.h"
#include "random_stream.h"

#include <cstddef>
#include <cstdint>

namespace fc {

// What a call brings along from outside the locks: the time, and what the predicates said.
struct CallInputs {
    struct Verdict {
        fc_predicate_fn predicate;
        void *user;
        bool holds;
    };

    bool has_time = false;
    std::int64_t now = 0;
    const Verdict *verdicts = nullptr;
    std::size_t count = 0;

    const Verdict *find(fc_predicate_fn predicate, void *user) const {
        for (std::size_t at = 0; at < count; ++at)
            if (verdicts[at].predicate == predicate && verdicts[at].user == user)
                return &verdicts[at];
        return nullptr;
    }
};

struct Trigger {
    static constexpr std::int64_t kForever = -1;

    std::uint64_t countdown = 0;      // calls still to pass before the first affected one
    std::int64_t duration = kForever; // affected calls left; negative: no limit

    enum Condition : std::uint8_t { kTime = 1, kRandom = 2, kPeriodic = 4, kWhen = 8 };
    std::uint8_t conditions = 0;
    std::int64_t start = 0; // kTime, in nanoseconds
    std::int64_t delay = 0;
    std::int64_t length = kForever;
    double probability = 1;   // kRandom
    std::uint64_t period = 1; // kPeriodic
    std::uint64_t active = 1;
    std::uint64_t passed = 0;            // calls since the delay
    fc_predicate_fn predicate = nullptr; // kWhen
    void *user = nullptr;

    void after(std::uint64_t calls) {
        countdown = calls;
        duration = kForever;
        passed = 0;
    }
    void once_after(std::uint64_t calls) {
        after(calls);
        duration = 1;
    }

    // One call passes. True when it is to be affected.
    bool advance(const CallInputs &inputs, RandomStream &random) {
        if (duration == 0)
            return false;
        if (countdown > 0) {
            --countdown;
            return false;
        }
        return conditions == 0 || conditions_hold(inputs, random);
    }

    // The call was affected.
    void consume() {
        if (duration > 0)
            --duration;
    }

    bool conditions_hold(const CallInputs &inputs, RandomStream &random);
};

} // namespace fc
