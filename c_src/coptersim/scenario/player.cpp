/* player.cpp: events in time. */
#include "player.hpp"

#include "parts.hpp"

#include <algorithm>

namespace csim_scenario {

player::player(csim *sim, const scenario &s) : sim_(sim), scenario_(s) {
    set_up();
}

bool player::check(int status, const char *what) {
    if (status != CSIM_OK && error_.empty()) {
        error_ = std::string(what) + ": " + csim_last_error_text();
    }
    return error_.empty();
}

void player::set_up() {
    if (!check(csim_reset(sim_), "reset")) {
        return;
    }
    fc_seed(csim_faults(sim_), scenario_.seed);
    check(csim_configure(sim_, scenario_.configuration.c_str()), "configuration");
    for (const setting &p : scenario_.settings) {
        check(csim_set(sim_, p.name.c_str(), p.value), p.name.c_str());
    }
    for (const gain_name &gain : gain_names) {
        check(csim_get(sim_, gain.name, &(gains_.*gain.member)), gain.name);
    }
    scenario_.gains.apply(gains_);
    check(csim_set_gains_all(sim_, &gains_), "gains");
    for (const line &l : scenario_.lines) {
        check(csim_add_line(sim_, l.id, l.x1, l.y1, l.x2, l.y2), "world.lines");
    }
    for (const anchor &a : scenario_.anchors) {
        check(csim_add_anchor(sim_, a.id, a.x, a.y, a.z), "world.anchors");
    }
    /* In ascending order each one goes to the end of the columns. */
    std::vector<const copter *> ascending;
    for (const copter &c : scenario_.copters) {
        ascending.push_back(&c);
    }
    std::sort(ascending.begin(), ascending.end(),
              [](const copter *a, const copter *b) { return a->id < b->id; });
    for (const copter *c : ascending) {
        if (!good()) {
            return;
        }
        set_up_copter(*c);
    }
}

void player::set_up_copter(const copter &c) {
    if (!check(csim_add_copter(sim_, c.id, c.px, c.py, c.yaw), "add a copter")) {
        return;
    }
    if (c.vx != 0 || c.vy != 0) {
        for (csim_view view : {CSIM_TRUE, CSIM_PERCEIVED}) {
            csim_state state;
            check(csim_get_state(sim_, c.id, view, &state), "state");
            state.vx = c.vx;
            state.vy = c.vy;
            check(csim_set_state(sim_, c.id, view, &state), "velocity");
        }
    }
    if (!c.gains.empty()) {
        csim_gains gains;
        check(csim_get_gains(sim_, c.id, &gains), "gains");
        c.gains.apply(gains);
        check(csim_set_gains(sim_, c.id, &gains), "gains");
    }
}

std::uint64_t player::time() const {
    return csim_time(sim_);
}

bool player::finished() const {
    return good() &&
           (csim_status(sim_) != CSIM_RUNNING || time() >= scenario_.steps() * scenario_.dt_us);
}

bool player::advance(std::uint64_t t_us) {
    std::uint64_t dt = scenario_.dt_us;
    std::uint64_t end = std::min(t_us / dt, scenario_.steps());
    while (good() && csim_status(sim_) == CSIM_RUNNING && time() / dt < end) {
        act_now();
        std::uint64_t next = next_change();
        std::uint64_t stop = next / dt + (next % dt != 0);
        std::uint64_t steps = std::min(end, stop) - time() / dt;
        if (good()) {
            check(csim_run(sim_, steps, dt, scenario_.its_div, scenario_.anchor_div), "run");
        }
    }
    return good();
}

bool player::act_due() {
    if (!finished()) {
        act_now();
    }
    return good();
}

/* The time of the first event that is still to come. */
std::uint64_t player::next_change() const {
    std::uint64_t next = UINT64_MAX - scenario_.dt_us;
    if (next_event_ < scenario_.events.size()) {
        next = scenario_.events[next_event_].t_us;
    }
    return next;
}

void player::act_now() {
    std::uint64_t now = time();
    while (good() && next_event_ < scenario_.events.size() &&
           scenario_.events[next_event_].t_us <= now) {
        const event &e = scenario_.events[next_event_++];
        if (on_event) {
            on_event(e);
        }
        std::visit([this](const auto &what) { act(what); }, e.what);
    }
}

void player::act(const command &c) {
    check(csim_command(sim_, c.copter, c.roll, c.pitch, c.yaw, c.throttle), "command");
}

void player::act(const change_gains &change) {
    csim_gains gains;
    if (change.copter) {
        check(csim_get_gains(sim_, *change.copter, &gains), "gains");
        change.gains.apply(gains);
        check(csim_set_gains(sim_, *change.copter, &gains), "gains");
        return;
    }
    csim_columns_view columns;
    check(csim_columns(sim_, CSIM_TRUE, &columns), "gains");
    std::vector<std::pair<std::int32_t, csim_gains>> changed;
    for (int i = 0; good() && i < columns.count; i++) {
        check(csim_get_gains(sim_, columns.id[i], &gains), "gains");
        change.gains.apply(gains);
        changed.emplace_back(columns.id[i], gains);
    }
    change.gains.apply(gains_); /* of those that come later; it also overwrites all others */
    check(csim_set_gains_all(sim_, &gains_), "gains");
    for (const auto &[id, own] : changed) {
        check(csim_set_gains(sim_, id, &own), "gains");
    }
}

void player::act(const change_params &change) {
    for (const setting &p : change.settings) {
        check(csim_set(sim_, p.name.c_str(), p.value), p.name.c_str());
    }
}

void player::act(const fault &f) {
    const event &e = scenario_.events[next_event_ - 1];
    fc_fault_id id = arm_fault(csim_faults(sim_), f, e.t_us, time());
    if (id <= 0) {
        error_ = "fault on " + f.id + ": " + fc_last_error_text();
    } else if (on_armed) {
        on_armed(e, f, id);
    }
}

void player::act(const clear_faults &c) {
    fc_context *context = csim_faults(sim_);
    if (!c.probe && !c.channel) {
        fc_remove_all_probe_faults(context);
        fc_channel_remove_all_faults(context);
    }
    if (c.probe) {
        fc_remove_probe_faults(context, c.probe->c_str());
    }
    if (c.channel) {
        fc_channel_remove_faults(context, c.channel->c_str());
    }
}

void player::act(const copter &c) {
    set_up_copter(c);
}

void player::act(const remove_copter &r) {
    if (on_remove) {
        on_remove(r.id);
    }
    check(csim_remove_copter(sim_, r.id), "remove_copter");
}

void player::act(const set_state &s) {
    for (csim_view view : {CSIM_TRUE, CSIM_PERCEIVED}) {
        const auto &values = view == CSIM_TRUE ? s.true_state : s.perceived;
        csim_state state;
        check(csim_get_state(sim_, s.id, view, &state), "set_state");
        for (std::size_t i = 0; i < values.size(); i++) {
            if (values[i]) {
                state.*state_names[i].member = *values[i];
            }
        }
        check(csim_set_state(sim_, s.id, view, &state), "set_state");
    }
}

} // namespace csim_scenario
