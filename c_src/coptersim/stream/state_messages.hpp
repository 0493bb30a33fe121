/* state_messages.hpp: what a simulation is like at this moment, as the messages of the folder lcm.
 * docs/visualizer.md says what each member is filled from. SI units and radians. */
#ifndef CSIM_STREAM_STATE_MESSAGES_HPP
#define CSIM_STREAM_STATE_MESSAGES_HPP

#include "csim.h"
#include "viz/frame.hpp"
#include "viz/ranges.hpp"
#include "viz/risk.hpp"

#include <cstdint>
#include <map>
#include <set>

namespace coptersim_stream {

enum object_flag { collided = 1, avoiding = 2, faulted = 4 };

/* As the copters are and believe to be; who is disturbed by a fault only the caller knows. */
viz::frame frame_of(const csim *sim, std::int32_t run, std::int32_t seq,
                    const std::set<std::int32_t> &faulted_copters);

/* What the observer reckons with; line_places: where a line stands in world.seg, by id. Without
 * ellipses when there is no such copter. */
viz::risk risk_of(const csim *sim, std::int32_t run, std::int32_t observer,
                  const std::map<std::int32_t, std::int32_t> &line_places);

/* The latest distance that a copter measured to each anchor. Empty when there is no such copter. */
viz::ranges ranges_of(const csim *sim, std::int32_t run, std::int32_t copter);

/* Rounds once; what is too large is infinite, every NaN is the same. */
float rounded(double x);
float radians(double degrees);

} // namespace coptersim_stream

#endif
