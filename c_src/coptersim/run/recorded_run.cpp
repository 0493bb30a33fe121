/* recorded_run.cpp: stops at the times of samples and of parts. */
#include "recorded_run.hpp"

#include "player.hpp"

#include <algorithm>
#include <numeric>

namespace coptersim_run {
namespace {

constexpr std::uint64_t never = UINT64_MAX;

/* The smallest common multiple, or never when it does not fit. */
std::uint64_t common_multiple(std::uint64_t a, std::uint64_t b) {
    std::uint64_t factor = b / std::gcd(a, b);
    return factor > never / a ? never : a * factor;
}

/* The first multiple of interval after t. */
std::uint64_t next_multiple(std::uint64_t t, std::uint64_t interval) {
    std::uint64_t count = t / interval + 1;
    return count > never / interval ? never : count * interval;
}

} // namespace

sim_owner new_simulation(int threads, const char *build) {
    csim_options options = CSIM_OPTIONS_INIT;
    options.threads = threads;
    options.build = build;
    return sim_owner(csim_new(&options));
}

std::optional<csim_trace::trace> recorded_run(csim *sim, const csim_scenario::scenario &s,
                                              const observer &o, std::string &error) {
    csim_scenario::player player(sim, s);
    csim_trace::recorder recorder(sim, s.name);
    player.on_remove = [&recorder](std::int32_t id) { recorder.keep(id); };
    std::uint64_t end = s.steps() * s.dt_us;
    std::uint64_t sample_interval = common_multiple(s.dt_us, s.record_every_us);
    std::uint64_t part = o.after_part ? common_multiple(s.dt_us, o.part_us) : never;
    if (player.good()) {
        recorder.sample();
        if (o.started) {
            o.started(sim);
        }
    }
    while (player.good() && !player.finished()) {
        std::uint64_t sample_at = next_multiple(player.time(), sample_interval);
        std::uint64_t part_at = next_multiple(player.time(), part);
        std::uint64_t stop = std::min({sample_at, part_at, end});
        player.advance(stop);
        if (player.time() == sample_at && csim_status(sim) == CSIM_RUNNING) {
            recorder.sample();
        }
        if (o.after_part && (player.time() == part_at || player.finished())) {
            o.after_part(sim);
        }
    }
    if (!player.good()) {
        error = player.error();
        return std::nullopt;
    }
    return recorder.finish();
}

} // namespace coptersim_run
