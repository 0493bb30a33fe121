/* replay.hpp: tells what happens in a run while it goes on, at a chosen speed. */
#ifndef CSIM_RUN_REPLAY_HPP
#define CSIM_RUN_REPLAY_HPP

#include "recorded_run.hpp"

#include <csignal>
#include <cstdio>

namespace coptersim_run {

class replay {
  public:
    /* Lines go to `to`. speed 0: without waiting; a wait ends when *interrupted is set. */
    replay(const csim_scenario::scenario &s, double part_ms, double speed, std::FILE *to,
           const volatile std::sig_atomic_t *interrupted);

    /* For recorded_run: parts of whole steps, at least one. */
    observer follower();

    /* After the run. */
    void tell_end(const csim_trace::trace &t) const;

  private:
    void after_part(const csim *sim);
    void tell_events(std::uint64_t now);
    void tell_status(const csim *sim) const;
    void wait_until(std::uint64_t t_us) const;

    const csim_scenario::scenario &scenario_;
    std::uint64_t part_us_;
    double speed_;
    std::FILE *to_;
    const volatile std::sig_atomic_t *interrupted_;
    double started_s_;
    std::size_t next_event_ = 0;
    std::uint64_t next_status_us_ = 0;
};

} // namespace coptersim_run

#endif
