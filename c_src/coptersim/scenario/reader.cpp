/* reader.cpp: the file as a whole: its members, ids that must differ, copters that must be there.
 */
#include "parts.hpp"

#include <algorithm>
#include <cstdio>
#include <set>
#include <unordered_set>

namespace csim_scenario {
namespace {

using id_set = std::unordered_set<std::int32_t>;

void need_new(id_set &ids, std::int32_t id, const node &value, const std::string &where) {
    if (!ids.insert(id).second) {
        throw located_error(value.line,
                            where + ": the id " + std::to_string(id) + " is there twice");
    }
}

std::string item(const std::string &array, std::size_t index) {
    return array + "[" + std::to_string(index) + "]";
}

void read_lines(const node *array, scenario &s) {
    if (array == nullptr) {
        return;
    }
    id_set ids;
    const std::vector<node> &items = as_array(*array, "world.lines", max_lines);
    for (std::size_t i = 0; i < items.size(); i++) {
        members m(items[i], item("world.lines", i));
        std::int32_t id = m.id("id");
        std::vector<double> p1 = as_numbers(m.need("p1"), m.path("p1"), 2);
        std::vector<double> p2 = as_numbers(m.need("p2"), m.path("p2"), 2);
        m.finish();
        need_new(ids, id, items[i], "world.lines");
        s.lines.push_back({id, p1[0], p1[1], p2[0], p2[1]});
    }
}

void read_anchors(const node *array, scenario &s) {
    if (array == nullptr) {
        return;
    }
    id_set ids;
    const std::vector<node> &items = as_array(*array, "world.anchors", max_anchors);
    for (std::size_t i = 0; i < items.size(); i++) {
        members m(items[i], item("world.anchors", i));
        std::int32_t id = m.id("id");
        std::vector<double> position = as_numbers(m.need("pos"), m.path("pos"), 3);
        m.finish();
        need_new(ids, id, items[i], "world.anchors");
        s.anchors.push_back({id, position[0], position[1], position[2]});
    }
}

void read_world(const node *world, scenario &s) {
    if (world == nullptr) {
        return;
    }
    members m(*world, "world");
    read_lines(m.find("lines"), s);
    read_anchors(m.find("anchors"), s);
    m.finish();
}

void read_copters(const node &array, scenario &s) {
    id_set ids;
    const std::vector<node> &items = as_array(array, "copters", max_copters);
    for (std::size_t i = 0; i < items.size(); i++) {
        members m(items[i], item("copters", i));
        copter c = read_copter(m);
        m.finish();
        need_new(ids, c.id, items[i], "copters");
        s.copters.push_back(c);
    }
}

void read_settings(members &top, scenario &s) {
    for (const char *name : {"altitude", "integrator", "halt_on_collision"}) {
        const node *value = top.find(name);
        if (value != nullptr) {
            s.settings.push_back(read_setting(name, *value, name));
        }
    }
    const node *params = top.find("params");
    if (params == nullptr) {
        return;
    }
    members m(*params, "params");
    if (const node *configuration = m.find("configuration")) {
        s.configuration = read_configuration(*configuration, m.path("configuration"));
    }
    for (std::size_t i : m.others()) {
        if (is_gain(m.key(i))) {
            throw located_error(m.value(i).line, m.path(m.key(i)) + ": belongs into gains");
        }
        s.settings.push_back(read_setting(m.key(i), m.value(i), m.path(m.key(i))));
    }
}

void read_events(const node *array, scenario &s) {
    if (array == nullptr) {
        return;
    }
    const std::vector<node> &items = as_array(*array, "events", max_events);
    for (std::size_t i = 0; i < items.size(); i++) {
        s.events.push_back(read_event(items[i], item("events", i)));
    }
    std::stable_sort(s.events.begin(), s.events.end(),
                     [](const event &a, const event &b) { return a.t_us < b.t_us; });
}

/* ---- Copters that events name are there at that time ---- */

struct copter_named {
    std::optional<std::int32_t> operator()(const command &c) const {
        return c.copter;
    }
    std::optional<std::int32_t> operator()(const change_gains &c) const {
        return c.copter;
    }
    std::optional<std::int32_t> operator()(const remove_copter &c) const {
        return c.id;
    }
    std::optional<std::int32_t> operator()(const set_state &c) const {
        return c.id;
    }
    template <class T> std::optional<std::int32_t> operator()(const T &) const {
        return std::nullopt;
    }
};

void check_copters_named(const scenario &s) {
    std::set<std::int32_t> present;
    for (const copter &c : s.copters) {
        present.insert(c.id);
    }
    for (const event &e : s.events) {
        std::optional<std::int32_t> id = std::visit(copter_named{}, e.what);
        if (id && present.count(*id) == 0) {
            throw located_error(e.line, "event at " + std::to_string(e.t_us) +
                                            " us: there is no copter " + std::to_string(*id));
        }
        if (const copter *added = std::get_if<copter>(&e.what)) {
            present.insert(added->id);
        } else if (const remove_copter *removed = std::get_if<remove_copter>(&e.what)) {
            present.erase(removed->id);
        }
        if (present.size() > max_copters) {
            throw located_error(e.line, "more than " + std::to_string(max_copters) + " copters");
        }
    }
}

scenario read_top(const node &root) {
    members top(root, "");
    const node &format = top.need("format");
    if (as_text(format, "format") != "coptersim-scenario/1") {
        throw located_error(format.line, "format: \"coptersim-scenario/1\" expected");
    }
    scenario s;
    s.name = top.text("name", "");
    s.dt_us = top.whole("dt_us", 1, 1000000000);
    s.duration_us = top.whole("duration_us", 0, largest_whole);
    s.its_div = static_cast<int>(top.whole("its_div", 0, INT32_MAX, 20));
    s.anchor_div = static_cast<int>(top.whole("anchor_div", 0, INT32_MAX, 20));
    s.seed = top.whole("seed", 0, UINT64_MAX, 1);
    s.gains = read_gains_object(top.find("gains"), "gains");
    read_settings(top, s);
    read_world(top.find("world"), s);
    read_copters(top.need("copters"), s);
    read_events(top.find("events"), s);
    const node *record = top.find("record");
    if (record != nullptr) {
        members m(*record, "record");
        s.record_every_us = m.whole("every_us", 1, largest_whole);
        m.finish();
    }
    top.finish();
    check_copters_named(s);
    return s;
}

} // namespace

bool read_scenario(std::string_view text, const std::string &file, scenario &result,
                   std::string &error) {
    try {
        if (text.size() > max_file_bytes) {
            throw located_error(0, "larger than 256 MiB; a scenario has at most " +
                                       std::to_string(max_copters) + " copters");
        }
        result = read_top(parse_located(text));
        return true;
    } catch (const located_error &e) {
        error = file + ":" + (e.line > 0 ? std::to_string(e.line) + ":" : "") + " " + e.what();
        return false;
    } catch (const std::bad_alloc &) {
        error = file + ": memory is exhausted";
        return false;
    }
}

bool read_scenario_file(const std::string &file, scenario &result, std::string &error) {
    std::FILE *in = file == "-" ? stdin : std::fopen(file.c_str(), "rb");
    std::string text;
    if (in != nullptr) {
        std::vector<char> part(std::size_t{1} << 20);
        std::size_t got;
        while (text.size() <= max_file_bytes &&
               (got = std::fread(part.data(), 1, part.size(), in)) > 0) {
            text.append(part.data(), got);
        }
    }
    bool failed = in == nullptr || std::ferror(in) != 0;
    if (in != nullptr && in != stdin) {
        std::fclose(in);
    }
    if (failed) {
        error = file + ": cannot be read";
        return false;
    }
    return read_scenario(text, file == "-" ? "standard input" : file, result, error);
}

} // namespace csim_scenario
