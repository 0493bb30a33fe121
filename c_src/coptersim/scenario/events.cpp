/* events.cpp: the events of a scenario, by type. */
#include "parts.hpp"

#include <cmath>
#include <limits>

namespace csim_scenario {
namespace {

/* ---- Faults ---- */

/* Each quantity of a copter that can be faulted; %: a number. The same list as in probes.cpp. */
const char *const probe_patterns[] = {"RangeId%Anch%", "PxId%",        "PyId%",    "PitchId%",
                                      "RollId%",       "YawId%",       "ClockId%", "AnchXId%Anch%",
                                      "AnchYId%Anch%", "AnchZId%Anch%"};
const char *const channel_patterns[] = {"ITS_DATA%"};

bool matches(const char *pattern, const char *name) {
    for (; *pattern != '\0'; pattern++) {
        if (*pattern != '%') {
            if (*name++ != *pattern) {
                return false;
            }
            continue;
        }
        const char *digits = name;
        while (*name >= '0' && *name <= '9') {
            name++;
        }
        if (name == digits || (*digits == '0' && name != digits + 1)) {
            return false;
        }
    }
    return *name == '\0';
}

template <std::size_t n>
void check_name(const node &value, const std::string &where, const std::string &name,
                const char *const (&patterns)[n]) {
    std::string known;
    for (const char *pattern : patterns) {
        if (matches(pattern, name.c_str())) {
            return;
        }
        known += (known.empty() ? "" : ", ") + std::string(pattern);
    }
    throw located_error(value.line, where + ": \"" + name + "\" is not a name of a " +
                                        "simulation; known, % a number: " + known);
}

/* NULL when the model or its parameter is unknown, which is found out when it is armed. */
const fc_parameter *find_parameter(const fault &f, const std::string &name) {
    const fc_parameter *parameter = nullptr;
    for (int i = 0; (parameter = fc_model_parameter(f.of_channel, f.model.c_str(), i)) != nullptr;
         i++) {
        if (name == parameter->name || (parameter->other != nullptr && name == parameter->other)) {
            break;
        }
    }
    return parameter;
}

/* JSON has no infinities and no NaN, so they are texts. */
fault_argument read_argument(const fault &f, const std::string &name, const node &value,
                             const std::string &where) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (value.kind != node::text) {
        return {name, std::nullopt, as_number(value, where)};
    }
    const std::string &text = as_text(value, where);
    const fc_parameter *parameter = find_parameter(f, name);
    if (parameter != nullptr && parameter->takes == FC_TAKES_TEXT) {
        return {name, text, 0};
    }
    if (text == "inf" || text == "-inf") {
        return {name, std::nullopt, text == "inf" ? infinity : -infinity};
    }
    if (text == "nan") {
        return {name, std::nullopt, std::numeric_limits<double>::quiet_NaN()};
    }
    return {name, text, 0};
}

/* What the library thinks of it, found out in a context that is thrown away. */
void check_fault(const fault &f, int line, const std::string &where) {
    fc_options options = FC_OPTIONS_INIT;
    options.on_error = [](void *, const fc_error *) {};
    fc_context *context = fc_new(&options);
    if (context == nullptr) {
        throw std::bad_alloc();
    }
    fc_fault_id id = arm_fault(context, f);
    std::string reason = id > 0 ? "" : fc_last_error_text();
    fc_free(context);
    if (id <= 0) {
        throw located_error(line, where + ": " + reason);
    }
}

fault read_fault(members &m, bool of_channel, const std::string &where) {
    fault f;
    f.of_channel = of_channel;
    const char *member = of_channel ? "channel" : "probe";
    const node &id = m.need(member);
    f.id = as_text(id, m.path(member));
    if (of_channel) {
        check_name(id, m.path(member), f.id, channel_patterns);
    } else {
        check_name(id, m.path(member), f.id, probe_patterns);
    }
    f.model = m.text("model");
    if (const node *duration = m.find("duration_us")) {
        f.duration_us = as_whole(*duration, m.path("duration_us"), 0, largest_whole);
    }
    const node *probability = m.find("probability");
    if (probability != nullptr && find_parameter(f, "probability") != nullptr) {
        f.arguments.push_back(read_argument(f, "probability", *probability, m.path("probability")));
    } else if (probability != nullptr) {
        f.probability = as_number(*probability, m.path("probability"));
    }
    if (const node *seed = m.find("seed")) {
        f.seed = as_whole(*seed, m.path("seed"), 0, UINT64_MAX);
    }
    for (std::size_t i : m.others()) {
        f.arguments.push_back(read_argument(f, m.key(i), m.value(i), m.path(m.key(i))));
    }
    check_fault(f, m.line(), where);
    return f;
}

clear_faults read_clear_faults(members &m) {
    clear_faults c;
    if (const node *probe = m.find("probe")) {
        c.probe = as_text(*probe, m.path("probe"));
        check_name(*probe, m.path("probe"), *c.probe, probe_patterns);
    }
    if (const node *channel = m.find("channel")) {
        c.channel = as_text(*channel, m.path("channel"));
        check_name(*channel, m.path("channel"), *c.channel, channel_patterns);
    }
    m.finish();
    return c;
}

/* ---- The others ---- */

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
                                "\" is unknown; known: command, gains, fault, packet_fault, "
                                "clear_faults, add_copter, remove_copter, set_state");
    }
    return e;
}

fc_fault_id arm_fault(fc_context *context, const fault &f) {
    std::vector<fc_argument> arguments;
    for (const fault_argument &a : f.arguments) {
        arguments.push_back({a.name.c_str(), a.text ? a.text->c_str() : nullptr, a.number});
    }
    auto arm = f.of_channel ? fc_channel_arm_named : fc_arm_named;
    fc_fault_id id =
        arm(context, f.id.c_str(), f.model.c_str(), arguments.data(), arguments.size());
    int status = FC_OK;
    if (id > 0 && f.probability) {
        status = fc_trigger_random(context, id, *f.probability);
    }
    if (id > 0 && f.seed && status == FC_OK) {
        status = fc_seed_fault(context, id, *f.seed);
    }
    if (status != FC_OK) {
        fc_remove(context, id);
        return status;
    }
    return id;
}

} // namespace csim_scenario
