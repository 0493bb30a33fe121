/* faults.cpp: events that arm faults or clear them: names, models, parameters, and when they act.
 */
#include "parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace csim_scenario {
namespace {

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

/* A receiver takes all packets of its channel in one step, so more copies, or longer ones, would
 * stop the simulated clock. */
constexpr double most_copies = 10000;
constexpr double most_added_bytes = 65536;

void add_argument(fault &f, const std::string &name, const node &value, const std::string &where) {
    fault_argument argument = read_argument(f, name, value, where);
    double most = !f.of_channel         ? HUGE_VAL
                  : f.model == "repeat" ? most_copies
                  : f.model == "extend" ? most_added_bytes
                                        : HUGE_VAL;
    if (!argument.text && argument.number > most) {
        throw located_error(value.line, where + ": " +
                                            std::to_string(static_cast<std::int64_t>(most)) +
                                            " are the most");
    }
    f.arguments.push_back(std::move(argument));
}

/* Beside the other members, and in an object of their own. */
void read_arguments(members &m, const node *params, fault &f) {
    if (params != nullptr) {
        members own(*params, m.path("params"));
        for (std::size_t i : own.others()) {
            add_argument(f, own.key(i), own.value(i), own.path(own.key(i)));
        }
    }
    for (std::size_t i : m.others()) {
        add_argument(f, m.key(i), m.value(i), m.path(m.key(i)));
    }
}

std::optional<std::uint64_t> read_count(members &m, const char *name, std::uint64_t most) {
    const node *value = m.find(name);
    return value == nullptr ? std::nullopt : std::optional(as_whole(*value, m.path(name), 0, most));
}

/* A window in time, or in calls. */
void read_window(members &m, fault &f, const std::string &where) {
    std::optional<std::uint64_t> delay = read_count(m, "delay_us", largest_whole);
    f.delay_us = delay.value_or(0);
    f.duration_us = read_count(m, "duration_us", largest_whole);
    f.from_calls = read_count(m, "from_calls", UINT64_MAX);
    f.for_calls = read_count(m, "for_calls", INT64_MAX);
    if ((delay || f.duration_us) && (f.from_calls || f.for_calls)) {
        throw located_error(m.line(), where + ": either delay_us and duration_us, or from_calls "
                                              "and for_calls");
    }
}

/* What the library thinks of it, found out in a context that is thrown away. */
void check_fault(const fault &f, int line, const std::string &where) {
    fc_options options = FC_OPTIONS_INIT;
    options.on_error = [](void *, const fc_error *) {};
    fc_context *context = fc_new(&options);
    if (context == nullptr) {
        throw std::bad_alloc();
    }
    fc_fault_id id = arm_fault(context, f, 0, 0);
    std::string reason = id > 0 ? "" : fc_last_error_text();
    fc_free(context);
    if (id <= 0) {
        throw located_error(line, where + ": " + reason);
    }
}

} // namespace

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
    read_window(m, f, where);
    const node *params = m.find("params");
    const node *probability = m.find("probability");
    if (probability != nullptr && find_parameter(f, "probability") != nullptr) {
        add_argument(f, "probability", *probability, m.path("probability"));
    } else if (probability != nullptr) {
        f.probability = as_number(*probability, m.path("probability"));
    }
    f.seed = read_count(m, "seed", UINT64_MAX);
    read_arguments(m, params, f);
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

window window_of(const fault &f, std::uint64_t t_us, std::uint64_t now_us) {
    window w{std::max(t_us + f.delay_us, now_us), std::nullopt};
    if (f.duration_us) {
        w.to_us = std::max(t_us + f.delay_us + *f.duration_us, w.from_us);
    }
    return w;
}

namespace {

int set_window(fc_context *context, fc_fault_id id, const fault &f, std::uint64_t t_us,
               std::uint64_t now_us) {
    constexpr std::int64_t ns_per_us = 1000;
    window w = window_of(f, t_us, now_us);
    auto ns = [](std::uint64_t us) { return static_cast<std::int64_t>(us) * ns_per_us; };
    std::int64_t forever = -1;
    return fc_trigger_time(context, id, ns(w.from_us - now_us),
                           w.to_us ? ns(*w.to_us - w.from_us) : forever);
}

/* The calls last: setting the first of them takes back how many they are. */
int set_trigger(fc_context *context, fc_fault_id id, const fault &f, std::uint64_t t_us,
                std::uint64_t now_us) {
    int status = f.seed ? fc_seed_fault(context, id, *f.seed) : FC_OK;
    if (status == FC_OK && (f.delay_us > 0 || f.duration_us)) {
        status = set_window(context, id, f, t_us, now_us);
    }
    if (status == FC_OK && f.probability) {
        status = fc_trigger_random(context, id, *f.probability);
    }
    if (status == FC_OK && f.from_calls) {
        status = fc_trigger_after(context, id, *f.from_calls);
    }
    if (status == FC_OK && f.for_calls) {
        status = fc_trigger_duration(context, id, static_cast<std::int64_t>(*f.for_calls));
    }
    return status;
}

} // namespace

fc_fault_id arm_fault(fc_context *context, const fault &f, std::uint64_t t_us,
                      std::uint64_t now_us) {
    std::vector<fc_argument> arguments;
    for (const fault_argument &a : f.arguments) {
        arguments.push_back({a.name.c_str(), a.text ? a.text->c_str() : nullptr, a.number});
    }
    auto arm = f.of_channel ? fc_channel_arm_named : fc_arm_named;
    fc_fault_id id =
        arm(context, f.id.c_str(), f.model.c_str(), arguments.data(), arguments.size());
    int status = id > 0 ? set_trigger(context, id, f, t_us, now_us) : FC_OK;
    if (status != FC_OK) {
        fc_remove(context, id);
        return status;
    }
    return id;
}

} // namespace csim_scenario
