/* streamed_run.cpp: stops where a listener wants a frame, and at every event. */
#include "streamed_run.hpp"

#include <algorithm>

namespace coptersim_stream {
namespace {

/* The end of the first step at or after t, where an event of that time acts. */
std::uint64_t step_at(std::uint64_t t_us, std::uint64_t dt_us) {
    return t_us / dt_us * dt_us + (t_us % dt_us != 0 ? dt_us : 0);
}

/* Of the events, the first that acts later than now. */
std::uint64_t next_event(const csim_scenario::scenario &s, std::uint64_t now, std::size_t &next) {
    while (next < s.events.size() && step_at(s.events[next].t_us, s.dt_us) <= now) {
        next++;
    }
    return next < s.events.size() ? step_at(s.events[next].t_us, s.dt_us) : UINT64_MAX;
}

bool tell_all(std::vector<teller> &tellers, story &tale, std::string &error) {
    tale.look();
    std::vector<viz::event> happened = tale.take_events();
    return std::all_of(tellers.begin(), tellers.end(),
                       [&](teller &t) { return t.tell(tale, happened, error); });
}

} // namespace

bool streamed_run(csim *sim, const csim_scenario::scenario &s,
                  const std::vector<listener> &listeners,
                  const std::function<void(std::uint64_t t_us)> &wait, outcome &result,
                  std::string &error) {
    csim_scenario::player player(sim, s);
    story tale(sim, s, player, listeners.empty() ? 1 : listeners.front().how.run);
    std::vector<teller> tellers;
    for (const listener &l : listeners) {
        tellers.emplace_back(sim, s, l.how, *l.to);
    }
    std::size_t event = 0;
    while (player.act_due()) {
        if (wait) {
            wait(player.time());
        }
        bool stopped = csim_status(sim) == CSIM_STOPPED;
        if (!stopped && !tell_all(tellers, tale, error)) {
            return false;
        }
        if (stopped || player.finished()) {
            result = {tale.how(), tale.reason()};
            return true;
        }
        std::uint64_t until = std::min(next_event(s, player.time(), event), s.steps() * s.dt_us);
        for (const teller &t : tellers) {
            until = std::min(until, step_at(t.next_us(), s.dt_us));
        }
        player.advance(until);
    }
    error = player.error();
    return false;
}

std::int32_t default_observer(const csim_scenario::scenario &s) {
    for (const csim_scenario::event &e : s.events) {
        const auto *fault = std::get_if<csim_scenario::fault>(&e.what);
        if (fault != nullptr && copter_of(fault->id) >= 0) {
            return copter_of(fault->id);
        }
    }
    auto first = std::min_element(
        s.copters.begin(), s.copters.end(),
        [](const csim_scenario::copter &a, const csim_scenario::copter &b) { return a.id < b.id; });
    return first == s.copters.end() ? -1 : first->id;
}

} // namespace coptersim_stream
