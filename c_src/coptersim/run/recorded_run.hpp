/* recorded_run.hpp: a scenario from its beginning to its end, with a trace of it. */
#ifndef CSIM_RECORDED_RUN_HPP
#define CSIM_RECORDED_RUN_HPP

#include "scenario.hpp"
#include "trace.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace coptersim_run {

struct sim_free {
    void operator()(csim *sim) const {
        csim_free(sim);
    }
};
using sim_owner = std::unique_ptr<csim, sim_free>;

/* With so many threads and a build of csim_build_at, NULL the fastest. Empty, and the reason in
 * csim_last_error_text, when that cannot be. */
sim_owner new_simulation(int threads, const char *build = nullptr);

/* Who wants to follow a run. Both functions may be empty; neither may change the run. */
struct observer {
    std::function<void(csim *sim)> started;          /* set up, at time 0 */
    std::function<void(const csim *sim)> after_part; /* at multiples of part_us, and at the end */
    std::uint64_t part_us = 1000000;
};

/* Samples at 0 and at the ends of steps that are multiples of the scenario's record_every_us, but
 * not after a collision that halts. Nothing, and one line in error, when the simulation refuses
 * something. */
std::optional<csim_trace::trace> recorded_run(csim *sim, const csim_scenario::scenario &s,
                                              const observer &o, std::string &error);

} // namespace coptersim_run

#endif
