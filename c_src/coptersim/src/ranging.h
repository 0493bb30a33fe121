// Ranges to anchors, the gate, and the correction of what a copter believes.
#pragma once

#include "columns.h"
#include "params.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coptersim {

struct Anchor {
    std::int32_t id;
    double x, y, z;
};

// What a copter remembers of one anchor.
struct RangeMemory {
    static constexpr std::size_t kRecent = 5;

    std::uint64_t accepted_at = 0; // us, the last accepted sample
    bool accepted = false;         // there is one
    bool out = false;              // misfits are followed
    bool misfit = false;           // the last sample was one
    std::uint32_t misfits = 0;     // in a row
    std::uint32_t samples = 0;
    double recent[kRecent] = {};       // m, errors of the last samples, a ring
    std::uint64_t measured_at = 0;     // us, the last sample; 0: none
    double measured = 0, expected = 0; // m, of it
    bool used = false;                 // it was accepted
    double last_x = 0, last_y = 0;     // m, correction vector of the last accepted sample
    double pos_x = 0, pos_y = 0, vel_x = 0, vel_y = 0, acc_x = 0, acc_y = 0; // integral parts
};

// Anchors in the order of adding, and the memories of all copters.
class Ranging {
  public:
    const std::vector<Anchor> &anchors() const {
        return anchors_;
    }
    int find(std::int32_t id) const; // index in anchors(), or -1
    void add_anchor(const Anchor &anchor, std::size_t copters);
    void clear_anchors();
    void insert_copter(std::size_t at);
    void erase_copter(std::size_t at);
    void clear_copters() {
        memories_.clear();
    }

    // The anchor to use next.
    std::size_t advance() {
        return next_ = (next_ + 1) % anchors_.size();
    }

    // The memories of one copter, in the order of anchors().
    RangeMemory *memories(std::size_t copter) {
        return memories_.data() + copter * anchors_.size();
    }
    const RangeMemory *memories(std::size_t copter) const {
        return memories_.data() + copter * anchors_.size();
    }

  private:
    std::vector<Anchor> anchors_;
    std::vector<RangeMemory> memories_;
    std::size_t next_ = 0;
};

// One distance, in one expression for both the true and the perceived position, so that they are
// equal when the positions are.
double distance_to(const Anchor &anchor, double x, double y, double z);

// What a sample is about.
struct RangeSample {
    Anchor anchor;   // where the estimator believes it is
    double measured; // m
    double altitude; // m
    std::uint64_t now;
};

// Corrects the belief of copter i. memories: its own, of `count` anchors; which: that of the
// sample.
void correct(const Params &params, const RangeSample &sample, RangeMemory *memories,
             std::size_t count, std::size_t which, std::size_t i, Columns *copters);

} // namespace coptersim
