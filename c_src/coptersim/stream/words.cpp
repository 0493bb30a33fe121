/* words.cpp: one function for each type of event. */
#include "words.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace coptersim_stream {
namespace {

using json = nlohmann::ordered_json;

/* Infinities and NaN are texts, as in a scenario. */
json number(double x) {
    if (std::isnan(x)) {
        return "nan";
    }
    if (std::isinf(x)) {
        return x > 0 ? "inf" : "-inf";
    }
    bool whole = x == std::floor(x) && std::fabs(x) < 1e15;
    return whole ? json(static_cast<std::int64_t>(x)) : json(x);
}

std::string dump(const json &value) {
    return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string list(std::initializer_list<std::string> parts) {
    std::string text;
    for (const std::string &part : parts) {
        text += (text.empty() ? "" : ", ") + part;
    }
    return text;
}

std::string quoted(const std::string &text) {
    return dump(json(text));
}

/* "#{pos_p => 0.1}": those of the names that have a value. */
template <class Names, class Values> std::string map_of(const Names &names, const Values &values) {
    std::string text;
    for (std::size_t i = 0; i < values.size(); i++) {
        if (values[i]) {
            text += (text.empty() ? "" : ", ") + std::string(names[i].name) + " => " +
                    number_text(*values[i]);
        }
    }
    return "#{" + text + "}";
}

words of(const csim_scenario::command &c) {
    return {"command", list({std::to_string(c.copter), number_text(c.roll), number_text(c.pitch),
                             number_text(c.yaw), number_text(c.throttle)})};
}

words of(const csim_scenario::change_gains &c) {
    std::string who = c.copter ? std::to_string(*c.copter) : "all";
    return {"gains", list({who, map_of(csim_scenario::gain_names, c.gains.values)})};
}

words of(const csim_scenario::change_params &c) {
    std::string text;
    for (const csim_scenario::setting &p : c.settings) {
        text += (text.empty() ? "" : ", ") + p.name + " => " + number_text(p.value);
    }
    return {"params", "#{" + text + "}"};
}

words of(const csim_scenario::fault &f) {
    std::string lasts = f.duration_us ? std::to_string(*f.duration_us) : "forever";
    return {f.of_channel ? "packet_fault" : "fault",
            list({quoted(f.id), quoted(f.model), quoted(parameters_of(f)), lasts})};
}

words of(const csim_scenario::clear_faults &c) {
    if (c.probe) {
        return {"clear_faults", quoted(*c.probe)};
    }
    return {"clear_faults", c.channel ? quoted(*c.channel) : "all"};
}

words of(const csim_scenario::copter &c) {
    return {"add_copter",
            list({std::to_string(c.id), number_text(c.px), number_text(c.py), number_text(c.yaw)})};
}

words of(const csim_scenario::remove_copter &r) {
    return {"remove_copter", std::to_string(r.id)};
}

words of(const csim_scenario::set_state &s) {
    return {"set_state",
            list({std::to_string(s.id), map_of(csim_scenario::state_names, s.true_state),
                  map_of(csim_scenario::state_names, s.perceived)})};
}

} // namespace

std::string number_text(double x) {
    json value = number(x);
    return value.is_string() ? value.get<std::string>() : value.dump();
}

words words_of(const csim_scenario::event &e) {
    return std::visit([](const auto &what) { return of(what); }, e.what);
}

std::string parameters_of(const csim_scenario::fault &f) {
    json parameters = json::object();
    for (const csim_scenario::fault_argument &a : f.arguments) {
        parameters[a.name] = a.text ? json(*a.text) : number(a.number);
    }
    if (f.probability && parameters.contains("probability")) {
        parameters = json{{"params", parameters}};
    }
    if (f.probability) {
        parameters["probability"] = number(*f.probability);
    }
    if (f.seed) {
        parameters["seed"] = *f.seed;
    }
    if (f.delay_us > 0) {
        parameters["delay_us"] = f.delay_us;
    }
    if (f.from_calls) {
        parameters["from_calls"] = *f.from_calls;
    }
    if (f.for_calls) {
        parameters["for_calls"] = *f.for_calls;
    }
    return dump(parameters);
}

} // namespace coptersim_stream
