// The names of probes and channels, and which of them want to be called.
//
// The fault context tells when anything was armed or removed; only then is its list read, so that
// idle probes, of which a large simulation has a hundred thousand, cost nothing at all.
#pragma once

#include "columns.h"
#include "fc.h"
#include "ranging.h"

#include <cstdint>
#include <string>
#include <vector>

namespace coptersim {

// In the order in which they are called for one copter.
enum class ProbeKind {
    pitch,
    roll,
    yaw,
    px,
    py,
    clock,
    anchor_x, // of copter and anchor, from here on
    anchor_y,
    anchor_z,
    range,
};

struct ActiveProbe {
    std::size_t copter; // index
    ProbeKind kind;
    std::size_t anchor; // index, of the kinds that have one
    std::string name;
};

std::string probe_name(ProbeKind kind, std::int32_t copter, std::int32_t anchor);
std::string channel_name(std::int32_t receiver);

class Probes {
  public:
    // Reads what is armed, when that has changed since the last call or `renewed`: copters or
    // anchors are others. True when anything may be different. CSIM_E_NOMEM becomes bad_alloc.
    bool refresh(fc_context *faults, const Columns &copters, const Ranging &ranging, bool renewed);

    // Attitude, position and clock, by copter.
    const std::vector<ActiveProbe> &of_copters() const {
        return of_copters_;
    }
    // Ranges and anchors, by copter and anchor.
    const std::vector<ActiveProbe> &of_ranges() const {
        return of_ranges_;
    }
    // Copters (indices, ascending) whose channel is armed or watched.
    const std::vector<std::size_t> &channels() const {
        return channels_;
    }

  private:
    void read_list(fc_context *faults, const Columns &copters, const Ranging &ranging);
    void add_everything(const Columns &copters, const Ranging &ranging);

    bool known_ = false;
    std::uint64_t changes_ = 0;
    std::vector<ActiveProbe> of_copters_, of_ranges_;
    std::vector<std::size_t> channels_;
};

} // namespace coptersim
