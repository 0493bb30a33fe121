// A fault that is armed: what is common to probes and channels.
#pragma once

#include "model.h"
#include "model_state.h"
#include "random_stream.h"
#include "trigger.h"

#include <cstdint>

namespace fc {

struct FaultCounts {
    std::uint64_t triggered = 0;
    std::uint64_t skipped = 0; // of those
    std::uint64_t idle = 0;    // of those: there was no packet
    int last_error = FC_OK;

    std::uint64_t applied() const {
        return triggered - skipped - idle;
    }
};

// What advances call by call. A get-stage channel fault has one for each receiver, any other fault
// one.
struct FaultRun {
    Trigger trigger;
    bool active = false; // triggered in the most recent call
    FaultCounts counts;
    ModelState state;
    std::uint64_t budget = 0; // DROP, REPEAT: packets left

    // One call passes the fault. True when it is to be applied.
    bool advance(bool enabled, const CallInputs &inputs, RandomStream &random) {
        active = enabled && trigger.advance(inputs, random);
        if (!active) {
            state.end_window();
            return false;
        }
        trigger.consume();
        ++counts.triggered;
        return true;
    }

    void count_skipped(int code) {
        ++counts.skipped;
        counts.last_error = code;
    }
};

struct Fault {
    fc_fault_id id = 0;
    std::uint64_t ordinal = 0; // among the faults its identifier has ever been given
    bool enabled = true;
    std::uint32_t causes_met = 0; // bit -code of each error reported
    RandomStream random;

    // True the first time.
    bool meets(int code) {
        const std::uint32_t bit = std::uint32_t{1} << -code;
        const bool first = (causes_met & bit) == 0;
        causes_met |= bit;
        return first;
    }
};

struct ProbeFault : Fault {
    Model model;
    FaultRun run;
};

} // namespace fc
