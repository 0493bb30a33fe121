/* teller.cpp: case and world, faults, frame, risk, ranges, status, in this order. */
#include "teller.hpp"

#include "state_messages.hpp"
#include "viz/status.hpp"

#include <algorithm>
#include <cmath>

namespace coptersim_stream {
namespace {

constexpr double frame_us = 20000;
constexpr std::int8_t mode_live = 1;

} // namespace

std::uint64_t frame_interval(std::uint64_t dt_us, double speed) {
    double dt = static_cast<double>(dt_us);
    return static_cast<std::uint64_t>(std::max(1.0, std::floor(frame_us * speed / dt))) * dt_us;
}

teller::teller(const csim *sim, const csim_scenario::scenario &s, const telling &how, sink &to)
    : sim_(sim), scenario_(s), how_(how), to_(to), line_places_(line_places(s)) {}

/* So many times a second; also marks it as told. */
bool teller::due(const char *channel, std::uint64_t per_second) {
    std::uint64_t now = csim_time(sim_);
    auto last = told_us_.find(channel);
    if (last != told_us_.end() && now - last->second < how_.pace_us / per_second) {
        return false;
    }
    told_us_[channel] = now;
    return true;
}

template <class M> bool teller::put(const char *channel, const M &message, std::string &error) {
    return to_.put(csim_time(sim_), channel, encoded(message), error);
}

bool teller::tell(story &s, const std::vector<viz::event> &happened, std::string &error) {
    std::uint64_t now = csim_time(sim_);
    for (const viz::event &event : happened) {
        if (!put("VIZ_EVENT", event, error)) {
            return false;
        }
    }
    if (now < next_us_ && happened.empty()) {
        return true;
    }
    next_us_ = (now / how_.frame_us + 1) * how_.frame_us;
    return tell_lasting(s, error) && tell_moment(s, error) && tell_status(s, error);
}

bool teller::tell_lasting(story &s, std::string &error) {
    if (due("VIZ_CASE", 1) && (!put("VIZ_CASE", case_of(scenario_), error) ||
                               !put("VIZ_WORLD", world_of(scenario_, how_.run), error))) {
        return false;
    }
    auto key = s.fault_key();
    if (key != fault_key_) {
        told_us_.erase("VIZ_FAULTS");
        fault_key_ = key;
    }
    return !due("VIZ_FAULTS", 1) || put("VIZ_FAULTS", s.faults(), error);
}

bool teller::tell_moment(story &s, std::string &error) {
    return put("VIZ_FRAME", frame_of(sim_, how_.run, frames_++, s.faulted()), error) &&
           put("VIZ_RISK", risk_of(sim_, how_.run, how_.observer, line_places_), error) &&
           (!due("VIZ_RANGE", 10) ||
            put("VIZ_RANGE", ranges_of(sim_, how_.run, how_.observer), error));
}

bool teller::tell_status(story &s, std::string &error) {
    if (s.how() != verdict_) {
        told_us_.erase("VIZ_STATUS");
        verdict_ = s.how();
    }
    if (!due("VIZ_STATUS", 5)) {
        return true;
    }
    viz::status status;
    status.mode = mode_live;
    status.paused = 0;
    status.speed = rounded(how_.speed);
    status.t_us = static_cast<std::int64_t>(csim_time(sim_));
    status.duration_us = static_cast<std::int64_t>(scenario_.steps() * scenario_.dt_us);
    status.run = how_.run;
    status.verdict = static_cast<std::int8_t>(s.how());
    status.control_allowed = 0;
    status.message = s.reason();
    return put("VIZ_STATUS", status, error);
}

} // namespace coptersim_stream
