/* writer.cpp: a trace as JSON, an array a line, and as comma-separated values. */
#include "trace.hpp"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace csim_trace {
namespace {

using values = std::array<std::vector<double>, quantity_count>;

std::string quoted(const std::string &text) {
    return nlohmann::json(text).dump();
}

template <class T> std::string whole(T value) {
    return std::to_string(value);
}

const char *kind_name(csim_collision_kind kind) {
    return kind == CSIM_TERRAIN ? "terrain" : "copter";
}

/* The copters that it happened to; of terrain, the one. */
std::string ids(const csim_collision &c) {
    return whole(c.id) + (c.kind == CSIM_COPTER ? "," + whole(c.other) : "");
}

std::string collision_json(const trace &t) {
    if (!t.collision) {
        return "null";
    }
    const csim_collision &c = *t.collision;
    std::string text = "{\"t_us\":" + whole(c.t_us) + ",\"kind\":\"" + kind_name(c.kind) +
                       "\",\"ids\":[" + ids(c) + "],\"point\":[";
    append_number(text, c.x);
    text += ",";
    append_number(text, c.y);
    return text + "]}";
}

/* With null for the times before the first sample. */
template <class T, class Append>
void append_array(std::string &text, const std::vector<T> &samples, std::size_t first,
                  Append append) {
    text += "[";
    for (std::size_t i = 0; i < first; i++) {
        text += i == 0 ? "null" : ",null";
    }
    for (std::size_t i = 0; i < samples.size(); i++) {
        text += i + first == 0 ? "" : ",";
        append(text, samples[i]);
    }
    text += "]";
}

void append_flag(std::string &text, std::uint8_t flag) {
    text += flag != 0 ? '1' : '0';
}

void append_state(std::string &text, const char *name, const values &state, std::size_t first) {
    text += "\"" + std::string(name) + "\":{";
    for (std::size_t k = 0; k < quantity_count; k++) {
        text += std::string(k == 0 ? "\n" : ",\n") + "\"" + quantity_names[k] + "\":";
        append_array(text, state[k], first, append_number);
    }
    text += "},\n";
}

std::string copter_json(std::int32_t id, const series &s) {
    std::string text = "\"" + whole(id) + "\":{";
    append_state(text, "true", s.true_state, s.first);
    append_state(text, "perceived", s.perceived, s.first);
    text += "\"override\":";
    append_array(text, s.override_active, s.first, append_flag);
    text += ",\n\"override_steps\":" + whole(s.override_steps) + ",\"max_pos_error\":";
    append_number(text, s.max_pos_error);
    return text + "}";
}

} // namespace

void append_number(std::string &text, double value) {
    if (!std::isfinite(value)) {
        text += "null";
        return;
    }
    char digits[32];
    std::to_chars_result end = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end.ptr);
}

void write_json(const trace &t, const sink &out) {
    std::string text = "{\"format\":\"coptersim-trace/1\",\"name\":" + quoted(t.name) +
                       ",\"end_t_us\":" + whole(t.end_t_us) +
                       ",\n\"collision\":" + collision_json(t) + ",\n\"t_us\":";
    append_array(text, t.t_us, 0,
                 [](std::string &to, std::uint64_t time) { to += std::to_string(time); });
    out(text + ",\n\"copters\":{");
    bool first = true;
    for (const auto &[id, s] : t.copters) {
        out(std::string(first ? "\n" : ",\n") + copter_json(id, s));
        first = false;
    }
    out("}}\n");
}

void write_csv(const trace &t, const sink &out) {
    std::string text = "t_us,copter";
    for (const char *state : {"true", "perceived"}) {
        for (const char *quantity : quantity_names) {
            text += "," + std::string(state) + "_" + quantity;
        }
    }
    out(text + ",override\n");
    for (std::size_t i = 0; i < t.t_us.size(); i++) {
        text.clear();
        for (const auto &[id, s] : t.copters) {
            if (i < s.first) {
                continue;
            }
            text += whole(t.t_us[i]) + "," + whole(id);
            for (const values *state : {&s.true_state, &s.perceived}) {
                for (const std::vector<double> &quantity : *state) {
                    text += ",";
                    append_number(text, quantity[i - s.first]);
                }
            }
            text += ",";
            append_flag(text, s.override_active[i - s.first]);
            text += "\n";
        }
        out(text);
    }
    if (t.collision) {
        const csim_collision &c = *t.collision;
        text = "# collision t_us=" + whole(c.t_us) + " kind=" + kind_name(c.kind) +
               " ids=" + ids(c) + " point=";
        append_number(text, c.x);
        text += ",";
        append_number(text, c.y);
        out(text + "\n");
    }
}

} // namespace csim_trace
