// How close copters came to each other and to lines: the objective of a guided search.
#pragma once

#include "columns.h"
#include "params.h"
#include "terrain.h"

namespace coptersim {

class Closeness {
  public:
    bool watching() const {
        return watching_;
    }
    void watch(csim_closeness_kind kind, std::uint64_t horizon_us);
    const csim_closeness &closest() const {
        return closest_;
    }
    // Looks at all true positions at a time.
    void look(const Params &params, const Terrain &terrain, const Columns &copters,
              std::uint64_t now);

  private:
    // gap in m, closing speed in m/s, braking in m/s^2
    double value_of(double gap, double closing, double braking) const;
    void offer(double value, std::uint64_t now, csim_collision_kind kind, std::int32_t id,
               std::int32_t other);

    bool watching_ = false;
    csim_closeness_kind kind_ = CSIM_GAP;
    double late_ = 0; // m, added at this time
    std::uint64_t horizon_us_ = 1;
    csim_closeness closest_{};
};

} // namespace coptersim
