/* scenario.hpp: what a file of the format coptersim-scenario/1 says (docs/copter_scenarios.md), and
 * reading one. Units as in csim.h: metres, degrees, microseconds. */
#ifndef CSIM_SCENARIO_HPP
#define CSIM_SCENARIO_HPP

#include "csim.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace csim_scenario {

constexpr std::size_t max_copters = 100000;
constexpr std::size_t max_lines = 100000;
constexpr std::size_t max_anchors = 100000;
constexpr std::size_t max_events = 1000000;
constexpr std::size_t max_file_bytes = std::size_t{256} << 20;

/* ---- Gains: the members of csim_gains by name ---- */

struct gain_name {
    const char *name;
    double csim_gains::*member;
};
constexpr std::size_t gain_count = 11;
extern const std::array<gain_name, gain_count> gain_names;

/* Those of the gains that a file names. */
struct gains_change {
    std::array<std::optional<double>, gain_count> values;

    bool empty() const;
    void apply(csim_gains &gains) const;
};

/* ---- The parts ---- */

/* A parameter of csim_param_at; a switch as 0 or 1, a choice as its number. */
struct setting {
    std::string name;
    double value;
};

struct line {
    std::int32_t id;
    double x1, y1, x2, y2;
};

struct anchor {
    std::int32_t id;
    double x, y, z;
};

struct copter {
    std::int32_t id;
    double px, py, yaw, vx, vy;
    gains_change gains;
};

struct command {
    std::int32_t copter;
    double roll, pitch, yaw, throttle;
};

struct change_gains {
    std::optional<std::int32_t> copter; /* none: all */
    gains_change gains;
};

/* Parameters that are no gains. */
struct change_params {
    std::vector<setting> settings;
};

/* An argument of a fault model, as fc_argument. */
struct fault_argument {
    std::string name;
    std::optional<std::string> text;
    double number;
};

struct fault {
    bool of_channel;
    std::string id; /* probe or channel */
    std::string model;
    std::vector<fault_argument> arguments;
    std::optional<double> probability; /* of each affected call */
    std::optional<std::uint64_t> seed; /* of its own random stream */
    /* A window in time, or in calls: delay or duration only without from and for. */
    std::uint64_t delay_us = 0;
    std::optional<std::uint64_t> duration_us;
    std::optional<std::uint64_t> from_calls; /* so many calls are spared first */
    std::optional<std::uint64_t> for_calls;  /* so many calls are affected */
};

/* Simulated times between which a fault may act; no end: for ever. */
struct window {
    std::uint64_t from_us;
    std::optional<std::uint64_t> to_us;
};
/* The window of a fault that is armed at now_us, for an event at t_us. */
window window_of(const fault &f, std::uint64_t t_us, std::uint64_t now_us);

struct clear_faults {
    std::optional<std::string> probe, channel; /* neither: all */
};

struct remove_copter {
    std::int32_t id;
};

/* Members that are left out stay as they are. */
struct set_state {
    static constexpr std::size_t count = 10;
    std::int32_t id;
    std::array<std::optional<double>, count> true_state, perceived;
};

struct state_name {
    const char *name;
    double csim_state::*member;
};
extern const std::array<state_name, set_state::count> state_names;

struct event {
    std::uint64_t t_us;
    int line; /* of the file */
    std::variant<command, change_gains, change_params, fault, clear_faults, copter, remove_copter,
                 set_state>
        what;
};

struct scenario {
    std::string name;
    std::uint64_t dt_us = 0, duration_us = 0;
    int its_div = 20, anchor_div = 20;
    std::uint64_t seed = 1;
    std::uint64_t record_every_us = 50000;
    std::string configuration = "default"; /* of csim_configuration_at */
    gains_change gains; /* of copters that say nothing else; the rest as in the configuration */
    std::vector<setting> settings; /* in the order of the file */
    std::vector<line> lines;
    std::vector<anchor> anchors;
    std::vector<copter> copters;
    std::vector<event> events; /* sorted by time, at equal times as in the file */

    /* Whole steps that fit into the duration. */
    std::uint64_t steps() const {
        return duration_us / dt_us;
    }
};

/* Reads the text of a scenario and checks all of it: ids, parameters, events that name copters
 * that are not there, models and parameters of faults. false: error is one line,
 * "file:line: reason". file is only named. */
bool read_scenario(std::string_view text, const std::string &file, scenario &result,
                   std::string &error);

/* The same from a file; "-" is standard input. */
bool read_scenario_file(const std::string &file, scenario &result, std::string &error);

/* One override "name=value", as from a command line: a gain, a parameter of csim_param_at, dt_us,
 * duration_us, its_div, anchor_div, seed or record_every_us. A gain also replaces what copters and
 * events say about it. "configuration=NAME" replaces all that the scenario says about gains and
 * "params". false: error says what is wrong. */
bool override_setting(scenario &s, const std::string &assignment, std::string &error);

} // namespace csim_scenario

#endif
