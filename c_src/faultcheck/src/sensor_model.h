// The sensor models: noise, drift, ramps, dropouts and the like.
#pragma once

#include "model.h"
#include "random_stream.h"

#include <cstdint>

namespace fc {

// What a sensor model knows of a call beside the value.
struct SensorCall {
    std::uint64_t k; // affected calls before this one in the window
    double first;    // the window's first x of this type (RAMP)
    double seconds;  // since the window's first call (DRIFT_TIMED)
    double unit;     // drawn last (HELD_OFFSET)
};

// The output for x; the models that keep bits instead of numbers (STUCK, DELAY, DROPOUT, bits) are
// elsewhere.
double compute_sensor(const Model &model, const SensorCall &call, RandomStream &random, double x);

} // namespace fc
