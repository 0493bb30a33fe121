/* streamed_run.hpp: plays a scenario from beginning to end and tells it to sinks. */
#ifndef CSIM_STREAM_STREAMED_RUN_HPP
#define CSIM_STREAM_STREAMED_RUN_HPP

#include "story.hpp"
#include "teller.hpp"

#include <functional>

namespace coptersim_stream {

struct listener {
    sink *to;
    telling how;
};

struct outcome {
    verdict how = verdict_running; /* running: it was stopped */
    std::string reason;            /* one line when it failed */
};

/* wait(t_us) is called before what has happened up to that simulated time is told; it may be empty.
 * A run that is stopped (csim_on_step) is no error. false: error is one line. */
bool streamed_run(csim *sim, const csim_scenario::scenario &s,
                  const std::vector<listener> &listeners,
                  const std::function<void(std::uint64_t t_us)> &wait, outcome &result,
                  std::string &error);

/* The copter to observe when nobody says: the first that meets a fault, or the first. -1: none. */
std::int32_t default_observer(const csim_scenario::scenario &s);

} // namespace coptersim_stream

#endif
