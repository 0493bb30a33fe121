// Contacts of true positions, each counted once until the two have separated.
#pragma once

#include "candidates.h"
#include "columns.h"
#include "params.h"
#include "terrain.h"

#include <vector>

namespace coptersim {

class Collisions {
  public:
    // In order of time, then as csim_collision is sorted.
    const std::vector<csim_collision> &recorded() const {
        return recorded_;
    }
    void forget() {
        recorded_.clear();
    }
    void clear() {
        recorded_.clear();
        touching_.clear();
    }
    // A copter or line of this id starts anew: a contact counts again.
    void forget_copter(std::int32_t id);
    void forget_line(std::int32_t id);
    void reserve(std::size_t copters);

    // Looks at all positions at a time; `table` nullptr: at all pairs. True when there are new
    // contacts.
    bool check(const Params &params, const Terrain &terrain, const Columns &copters,
               const ContactTable *table, std::uint64_t now);

  private:
    void find_pairs(const Params &params, const Columns &copters, const ContactTable *table,
                    std::uint64_t now);
    void find_lines(const Params &params, const Terrain &terrain, const Columns &copters,
                    const ContactTable *table, std::uint64_t now);

    std::vector<csim_collision> recorded_;
    std::vector<csim_collision> found_, touching_; // of this step, of the one before; sorted
};

} // namespace coptersim
