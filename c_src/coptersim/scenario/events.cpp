/* events.cpp: the events of a scenario, by type. */
#include "parts.hpp"

namespace csim_scenario {
namespace {

command read_command(members &m) {
    command c{};
    c.copter = m.id("copter");
    c.roll = m.number("roll", 0);
    c.pitch = m.number("pitch", 0);
    c.yaw = m.number("yaw", 0);
    c.throttle = m.number("throttle", 0);
    m.finish();
    return c;
}

change_gains read_change_gains(members &m) {
    change_gains change;
    if (m.find("copter") != nullptr) {
        change.copter = m.id("copter");
    }
    change.gains = read_gains(m);
    m.finish();
    return change;
}

change_params read_change_params(members &m) {
    change_params change;
    for (std::size_t i : m.others()) {
        if (is_gain(m.key(i))) {
            throw located_error(m.value(i).line,
                                m.path(m.key(i)) + ": belongs into an event of type gains");
        }
        change.settings.push_back(read_setting(m.key(i), m.value(i), m.path(m.key(i))));
    }
    return change;
}

std::array<std::optional<double>, set_state::count> read_state(const node *value,
                                                               const std::string &where) {
    std::array<std::optional<double>, set_state::count> state;
    if (value == nullptr) {
        return state;
    }
    members m(*value, where);
    for (std::size_t i = 0; i < state.size(); i++) {
        const char *name = state_names[i].name;
        if (const node *number = m.find(name)) {
            state[i] = as_number(*number, m.path(name));
        }
    }
    m.finish();
    return state;
}

set_state read_set_state(members &m) {
    set_state s;
    s.id = m.id("id");
    s.true_state = read_state(m.find("true"), m.path("true"));
    s.perceived = read_state(m.find("perceived"), m.path("perceived"));
    m.finish();
    return s;
}

copter read_add_copter(members &m) {
    copter c = read_copter(m);
    m.finish();
    return c;
}

remove_copter read_remove_copter(members &m) {
    remove_copter r{m.id("id")};
    m.finish();
    return r;
}

} // namespace

event read_event(const node &value, const std::string &where) {
    members m(value, where);
    event e{m.whole("t_us", 0, largest_whole), value.line, command{}};
    const node &type_node = m.need("type");
    const std::string &type = as_text(type_node, m.path("type"));
    if (type == "command") {
        e.what = read_command(m);
    } else if (type == "gains") {
        e.what = read_change_gains(m);
    } else if (type == "params") {
        e.what = read_change_params(m);
    } else if (type == "fault" || type == "packet_fault") {
        e.what = read_fault(m, type == "packet_fault", where);
    } else if (type == "clear_faults") {
        e.what = read_clear_faults(m);
    } else if (type == "add_copter") {
        e.what = read_add_copter(m);
    } else if (type == "remove_copter") {
        e.what = read_remove_copter(m);
    } else if (type == "set_state") {
        e.what = read_set_state(m);
    } else {
        throw located_error(type_node.line,
                            m.path("type") + ": \"" + type +
                                "\" is unknown; known: command, gains, params, fault, "
                                "packet_fault, clear_faults, add_copter, remove_copter, set_state");
    }
    return e;
}

} // namespace csim_scenario
