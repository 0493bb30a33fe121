/* replay.cpp: a line for each event, one a simulated second, and the end. */
#include "replay.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <ctime>

namespace coptersim_run {
namespace {

constexpr std::uint64_t status_every_us = 1000000;

double clock_s() {
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double seconds(std::uint64_t t_us) {
    return 1e-6 * static_cast<double>(t_us);
}

/* An event in a few words. */
struct words {
    std::string operator()(const csim_scenario::command &c) const {
        char text[128];
        std::snprintf(text, sizeof text, "copter %d: roll %.3g pitch %.3g yaw %.3g", c.copter,
                      c.roll, c.pitch, c.yaw);
        return text;
    }
    std::string operator()(const csim_scenario::change_gains &) const {
        return "gains change";
    }
    std::string operator()(const csim_scenario::change_params &change) const {
        std::string text = "set";
        for (const csim_scenario::setting &p : change.settings) {
            char number[40];
            std::snprintf(number, sizeof number, "%g", p.value);
            text += " " + p.name + " " + number;
        }
        return text;
    }
    std::string operator()(const csim_scenario::fault &f) const {
        std::string text = "fault " + f.model + " on " + f.id;
        for (const csim_scenario::fault_argument &a : f.arguments) {
            char number[40];
            std::snprintf(number, sizeof number, "%g", a.number);
            text += " " + a.name + " " + (a.text ? *a.text : number);
        }
        return text;
    }
    std::string operator()(const csim_scenario::clear_faults &) const {
        return "faults cleared";
    }
    std::string operator()(const csim_scenario::copter &c) const {
        return "copter " + std::to_string(c.id) + " appears";
    }
    std::string operator()(const csim_scenario::remove_copter &r) const {
        return "copter " + std::to_string(r.id) + " is taken away";
    }
    std::string operator()(const csim_scenario::set_state &s) const {
        return "copter " + std::to_string(s.id) + " is put elsewhere";
    }
};

/* "copters 0 and 1", "copter 0 and line 1000". */
std::string pair_of(csim_collision_kind kind, std::int32_t id, std::int32_t other) {
    std::string first = std::to_string(id), second = std::to_string(other);
    return kind == CSIM_COPTER ? "copters " + first + " and " + second
                               : "copter " + first + " and line " + second;
}

} // namespace

replay::replay(const csim_scenario::scenario &s, double part_ms, double speed, std::FILE *to,
               const volatile std::sig_atomic_t *interrupted)
    : scenario_(s), speed_(speed), to_(to), interrupted_(interrupted), started_s_(clock_s()) {
    double steps = std::max(1.0, std::round(part_ms * 1000 / static_cast<double>(s.dt_us)));
    part_us_ = static_cast<std::uint64_t>(steps) * s.dt_us;
}

observer replay::follower() {
    observer o;
    o.started = [this](csim *sim) {
        csim_watch_closeness(sim, CSIM_GAP, std::max<std::uint64_t>(scenario_.duration_us, 1));
    };
    o.after_part = [this](const csim *sim) { after_part(sim); };
    o.part_us = part_us_;
    return o;
}

void replay::after_part(const csim *sim) {
    std::uint64_t now = csim_time(sim);
    tell_events(now);
    if (now >= next_status_us_) {
        tell_status(sim);
        next_status_us_ = (now / status_every_us + 1) * status_every_us;
    }
    std::fflush(to_);
    wait_until(now);
}

/* Those that have acted on the steps up to now. */
void replay::tell_events(std::uint64_t now) {
    while (next_event_ < scenario_.events.size() && scenario_.events[next_event_].t_us < now) {
        const csim_scenario::event &e = scenario_.events[next_event_++];
        std::fprintf(to_, "%10.3f s  %s\n", seconds(e.t_us), std::visit(words{}, e.what).c_str());
    }
}

void replay::tell_status(const csim *sim) const {
    csim_columns_view columns;
    csim_columns(sim, CSIM_TRUE, &columns);
    int overridden = 0;
    double error = 0;
    for (int i = 0; i < columns.count; i++) {
        csim_station station;
        csim_override(sim, columns.id[i], &station);
        overridden += station.active;
        error = std::max(error, station.max_pos_error);
    }
    std::fprintf(to_, "%10.3f s  avoiding: %d of %d, largest position error so far %.3f m",
                 seconds(csim_time(sim)), overridden, columns.count, error);
    csim_closeness closest;
    if (csim_closest(sim, &closest) == CSIM_OK && std::isfinite(closest.value)) {
        std::fprintf(to_, ", smallest gap %.3f m (%s)", closest.value,
                     pair_of(closest.kind, closest.id, closest.other).c_str());
    }
    std::fprintf(to_, "\n");
}

void replay::tell_end(const csim_trace::trace &t) const {
    if (t.collision) {
        const csim_collision &c = *t.collision;
        std::fprintf(to_, "%10.3f s  collision of %s at (%.3f, %.3f)\n", seconds(c.t_us),
                     pair_of(c.kind, c.id, c.other).c_str(), c.x, c.y);
    } else {
        std::fprintf(to_, "%10.3f s  end, no collision\n", seconds(t.end_t_us));
    }
}

/* Against the clock at the start, so that waits do not add up. */
void replay::wait_until(std::uint64_t t_us) const {
    if (!(speed_ > 0)) {
        return;
    }
    double at = started_s_ + seconds(t_us) / speed_;
    timespec deadline;
    deadline.tv_sec = static_cast<time_t>(at);
    deadline.tv_nsec = static_cast<long>((at - std::floor(at)) * 1e9);
    while (*interrupted_ == 0 &&
           clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, nullptr) == EINTR) {
    }
}

} // namespace coptersim_run
