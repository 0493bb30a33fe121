/* parts.cpp: gains, parameters and copters. */
#include "parts.hpp"

#include <algorithm>
#include <cstdio>

namespace csim_scenario {
namespace {

const csim_param *find_param(const std::string &name) {
    for (int i = 0; i < csim_param_count(); i++) {
        const csim_param *param = csim_param_at(i);
        if (name == param->name) {
            return param;
        }
    }
    return nullptr;
}

std::string shortest(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.10g", value);
    return text;
}

/* All names, for a message. */
std::string param_names() {
    std::string names;
    for (int i = 0; i < csim_param_count(); i++) {
        names += (i == 0 ? "" : ", ") + std::string(csim_param_at(i)->name);
    }
    return names;
}

double choice(const csim_param &param, const node &value, const std::string &where) {
    std::string names;
    int count = static_cast<int>(param.max) + 1;
    for (int i = 0; i < count; i++) {
        names += (i == 0 ? "" : i + 1 == count ? " or " : ", ") + std::string(param.choices[i]);
    }
    const std::string *name = value.kind == node::text ? &value.characters : nullptr;
    for (int i = 0; i < count; i++) {
        bool by_number = value.kind == node::number && value.real == i;
        if (by_number || (name != nullptr && *name == param.choices[i])) {
            return i;
        }
    }
    throw located_error(value.line, where + ": " + names + " expected");
}

} // namespace

gains_change read_gains(members &m) {
    gains_change change;
    for (std::size_t i = 0; i < gain_count; i++) {
        const char *name = gain_names[i].name;
        const node *value = m.find(name);
        if (value != nullptr) {
            change.values[i] = read_setting(name, *value, m.path(name)).value;
        }
    }
    return change;
}

gains_change read_gains_object(const node *value, const std::string &where) {
    if (value == nullptr) {
        return {};
    }
    members m(*value, where);
    gains_change change = read_gains(m);
    m.finish();
    return change;
}

setting read_setting(const std::string &name, const node &value, const std::string &where) {
    const csim_param *param = find_param(name);
    if (param == nullptr) {
        throw located_error(value.line, where + ": unknown parameter; known: " + param_names());
    }
    bool bit = value.kind == node::number && (value.real == 0 || value.real == 1);
    if (param->kind == CSIM_SWITCH && bit) {
        return {name, value.real};
    }
    if (param->kind == CSIM_SWITCH) {
        return {name, as_truth(value, where) ? 1.0 : 0.0};
    }
    if (param->kind == CSIM_CHOICE) {
        return {name, choice(*param, value, where)};
    }
    double number = as_number(value, where);
    if (!(number >= param->min && number <= param->max)) {
        throw located_error(value.line, where + ": a number from " + shortest(param->min) + " to " +
                                            shortest(param->max) + " expected");
    }
    return {name, number};
}

std::string read_configuration(const node &value, const std::string &where) {
    const std::string &name = as_text(value, where);
    std::string names;
    for (int i = 0; const char *known = csim_configuration_at(i); i++) {
        if (name == known) {
            return name;
        }
        names += (i == 0 ? "" : " or ") + std::string(known);
    }
    throw located_error(value.line, where + ": " + names + " expected");
}

copter read_copter(members &m) {
    copter c{};
    c.id = m.id("id");
    std::vector<double> position = as_numbers(m.need("pos"), m.path("pos"), 2);
    c.px = position[0];
    c.py = position[1];
    c.yaw = m.number("yaw", 0);
    if (const node *velocity = m.find("vel")) {
        std::vector<double> v = as_numbers(*velocity, m.path("vel"), 2);
        c.vx = v[0];
        c.vy = v[1];
    }
    c.gains = read_gains_object(m.find("gains"), m.path("gains"));
    return c;
}

/* ---- Overrides from a command line ---- */

namespace {

/* The value as JSON would write it; a word that is not JSON is a text. */
node value_of(const std::string &text) {
    try {
        node value = parse_located(text);
        if (value.kind != node::array && value.kind != node::object) {
            return value;
        }
    } catch (const located_error &) {
        /* a word */
    }
    node value;
    value.kind = node::text;
    value.characters = text;
    return value;
}

/* Nobody says anything about a gain any more. */
void forget_gain(scenario &s, std::size_t index) {
    s.gains.values[index].reset();
    for (copter &c : s.copters) {
        c.gains.values[index].reset();
    }
    for (event &e : s.events) {
        if (change_gains *change = std::get_if<change_gains>(&e.what)) {
            change->gains.values[index].reset();
        } else if (copter *added = std::get_if<copter>(&e.what)) {
            added->gains.values[index].reset();
        }
    }
}

/* Nobody says anything about parameters that are picked any more. */
template <class Pick> void forget_settings(scenario &s, Pick pick) {
    auto forget = [pick](std::vector<setting> &settings) {
        settings.erase(std::remove_if(settings.begin(), settings.end(), pick), settings.end());
    };
    forget(s.settings);
    for (event &e : s.events) {
        if (change_params *change = std::get_if<change_params>(&e.what)) {
            forget(change->settings);
        }
    }
}

bool override_configuration(scenario &s, const std::string &name, const node &value) {
    if (name != "configuration") {
        return false;
    }
    s.configuration = read_configuration(value, name);
    for (std::size_t i = 0; i < gain_count; i++) {
        forget_gain(s, i);
    }
    forget_settings(s, [](const setting &p) {
        return p.name != "altitude" && p.name != "integrator" && p.name != "halt_on_collision";
    });
    return true;
}

bool override_gain(scenario &s, const std::string &name, const node &value) {
    for (std::size_t i = 0; i < gain_count; i++) {
        if (name == gain_names[i].name) {
            double number = read_setting(name, value, name).value;
            forget_gain(s, i);
            s.gains.values[i] = number;
            return true;
        }
    }
    return false;
}

bool override_time(scenario &s, const std::string &name, const node &value) {
    if (name == "dt_us") {
        s.dt_us = as_whole(value, name, 1, 1000000000);
    } else if (name == "duration_us") {
        s.duration_us = as_whole(value, name, 0, largest_whole);
    } else if (name == "its_div") {
        s.its_div = static_cast<int>(as_whole(value, name, 0, INT32_MAX));
    } else if (name == "anchor_div") {
        s.anchor_div = static_cast<int>(as_whole(value, name, 0, INT32_MAX));
    } else if (name == "seed") {
        s.seed = as_whole(value, name, 0, UINT64_MAX);
    } else if (name == "record_every_us") {
        s.record_every_us = as_whole(value, name, 1, largest_whole);
    } else {
        return false;
    }
    return true;
}

} // namespace

bool override_setting(scenario &s, const std::string &assignment, std::string &error) {
    std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0) {
        error = "\"" + assignment + "\": name=value expected";
        return false;
    }
    std::string name = assignment.substr(0, equals);
    try {
        node value = value_of(assignment.substr(equals + 1));
        if (!override_configuration(s, name, value) && !override_gain(s, name, value) &&
            !override_time(s, name, value)) {
            setting given = read_setting(name, value, name);
            forget_settings(s, [&name](const setting &p) { return p.name == name; });
            s.settings.push_back(given);
        }
        return true;
    } catch (const located_error &e) {
        error = e.what();
        return false;
    }
}

} // namespace csim_scenario
