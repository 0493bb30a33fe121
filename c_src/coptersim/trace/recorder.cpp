/* recorder.cpp: takes samples of all copters. */
#include "trace.hpp"

#include <algorithm>
#include <limits>

namespace csim_trace {

const std::array<const char *, quantity_count> quantity_names = {"px",   "py",    "vx", "vy",
                                                                 "roll", "pitch", "yaw"};

namespace {

using columns = std::array<const double *, quantity_count>;
using values = std::array<std::vector<double>, quantity_count>;

columns columns_of(const csim_columns_view &view) {
    return {view.px, view.py, view.vx, view.vy, view.roll, view.pitch, view.yaw};
}

/* Up to so many samples; what is missing is not known. */
void fill_up(series &s, std::size_t count) {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    for (values *state : {&s.true_state, &s.perceived}) {
        for (std::vector<double> &quantity : *state) {
            quantity.resize(count, unknown);
        }
    }
    s.override_active.resize(count, 0);
}

void append(values &state, const columns &from, std::size_t row) {
    for (std::size_t k = 0; k < quantity_count; k++) {
        state[k].push_back(from[k][row]);
    }
}

} // namespace

recorder::recorder(const csim *sim, std::string name) : sim_(sim) {
    trace_.name = std::move(name);
}

void recorder::sample() {
    csim_columns_view true_view, perceived_view;
    csim_columns(sim_, CSIM_TRUE, &true_view);
    csim_columns(sim_, CSIM_PERCEIVED, &perceived_view);
    columns true_columns = columns_of(true_view), perceived = columns_of(perceived_view);
    std::size_t index = trace_.t_us.size();
    trace_.t_us.push_back(csim_time(sim_));
    for (std::size_t row = 0; row < static_cast<std::size_t>(true_view.count); row++) {
        auto [found, added] = trace_.copters.try_emplace(true_view.id[row]);
        series &s = found->second;
        if (added) {
            s.first = index;
        }
        fill_up(s, index - s.first);
        append(s.true_state, true_columns, row);
        append(s.perceived, perceived, row);
        s.override_active.push_back(true_view.override_active[row]);
    }
}

void recorder::keep(std::int32_t id) {
    auto found = trace_.copters.find(id);
    csim_station station;
    if (found != trace_.copters.end() && csim_override(sim_, id, &station) == CSIM_OK) {
        found->second.override_steps += station.steps;
        found->second.max_pos_error = std::max(found->second.max_pos_error, station.max_pos_error);
    }
}

trace recorder::finish() {
    trace_.end_t_us = csim_time(sim_);
    csim_collision first;
    std::size_t count = 1;
    int status = csim_collisions(sim_, &first, &count);
    if ((status == CSIM_OK || status == CSIM_E_SPACE) && count > 0) {
        trace_.collision = first;
    }
    csim_columns_view view;
    csim_columns(sim_, CSIM_TRUE, &view);
    for (int row = 0; row < view.count; row++) {
        keep(view.id[row]);
    }
    for (auto &[id, s] : trace_.copters) {
        fill_up(s, trace_.t_us.size() - s.first);
    }
    return std::move(trace_);
}

} // namespace csim_trace
