/* story.cpp: listens to the player of a scenario, and looks at its simulation. */
#include "story.hpp"

#include "state_messages.hpp"
#include "words.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace coptersim_stream {
namespace {

constexpr std::int64_t no_end = -1;

/* "copters 0 and 1 collided", "copter 0 met terrain line 1000". */
std::string met(const csim_collision &c) {
    std::string first = std::to_string(c.id), second = std::to_string(c.other);
    return c.kind == CSIM_COPTER ? "copters " + first + " and " + second + " collided"
                                 : "copter " + first + " met terrain line " + second;
}

std::string met_where(const csim_collision &c) {
    char text[128];
    std::snprintf(text, sizeof text, " at %.6f s, (%.3f, %.3f)", 1e-6 * static_cast<double>(c.t_us),
                  c.x, c.y);
    return met(c) + text;
}

std::vector<csim_collision> collisions_of(const csim *sim) {
    std::size_t count = 0;
    csim_collisions(sim, nullptr, &count);
    std::vector<csim_collision> list(count);
    csim_collisions(sim, list.data(), &count);
    return list;
}

} // namespace

story::story(csim *sim, const csim_scenario::scenario &s, csim_scenario::player &player,
             std::int32_t run)
    : sim_(sim), scenario_(s), player_(player), run_(run), line_places_(line_places(s)) {
    player.on_event = [this](const csim_scenario::event &e) { on_event(e); };
    player.on_armed = [this](const csim_scenario::event &e, const csim_scenario::fault &f,
                             fc_fault_id id) { on_armed(e, f, id); };
}

std::int64_t story::now() const {
    return static_cast<std::int64_t>(csim_time(sim_));
}

void story::tell(const char *kind, std::int64_t t_us, std::string text, std::int32_t a,
                 std::int32_t b, double x, double y) {
    viz::event event;
    event.t_us = t_us;
    event.run = run_;
    event.seq = next_seq_++;
    event.kind = kind;
    event.a = a;
    event.b = b;
    event.x = rounded(x);
    event.y = rounded(y);
    event.text = std::move(text);
    events_.push_back(std::move(event));
}

std::vector<viz::event> story::take_events() {
    return std::exchange(events_, {});
}

void story::on_event(const csim_scenario::event &e) {
    std::ptrdiff_t index = &e - scenario_.events.data();
    tell("command", now(), words_of(e).text(), static_cast<std::int32_t>(index));
    if (const auto *c = std::get_if<csim_scenario::clear_faults>(&e.what)) {
        clear(*c);
    }
}

void story::on_armed(const csim_scenario::event &e, const csim_scenario::fault &f, fc_fault_id id) {
    told_fault told{id, {}};
    told.message.object = copter_of(f.id);
    told.message.probe = f.id;
    told.message.type = f.model;
    told.message.params = parameters_of(f);
    csim_scenario::window w = csim_scenario::window_of(f, e.t_us, csim_time(sim_));
    told.message.from_us = static_cast<std::int64_t>(w.from_us);
    told.message.to_us = w.to_us ? static_cast<std::int64_t>(*w.to_us) : no_end;
    told.message.hits = 0;
    tell("fault", now(), f.id + ": " + f.model + " " + told.message.params, told.message.object);
    faults_.push_back(std::move(told));
}

/* Before they are disarmed. */
void story::clear(const csim_scenario::clear_faults &c) {
    keep_hits();
    bool all = !c.probe && !c.channel;
    for (told_fault &f : faults_) {
        bool channel = f.message.probe.compare(0, 8, "ITS_DATA") == 0;
        const std::optional<std::string> &name = channel ? c.channel : c.probe;
        bool over = f.message.to_us != no_end && f.message.to_us <= now();
        if (!over && (all || (name && *name == f.message.probe))) {
            f.message.to_us = now();
        }
    }
}

/* How many values or packets each armed fault has changed so far. */
std::map<fc_fault_id, std::uint64_t> story::applied() const {
    std::map<fc_fault_id, std::uint64_t> sums;
    if (!faults_.empty()) {
        auto visit = [](void *user, const fc_listed *listed) {
            auto *to = static_cast<std::map<fc_fault_id, std::uint64_t> *>(user);
            for (std::size_t i = 0; i < listed->fault_count; i++) {
                (*to)[listed->faults[i].id] += listed->faults[i].applied;
            }
        };
        fc_list(csim_faults(sim_), visit, &sums);
    }
    return sums;
}

void story::keep_hits() {
    std::map<fc_fault_id, std::uint64_t> sums = applied();
    for (told_fault &f : faults_) {
        auto found = sums.find(f.id);
        if (found != sums.end()) {
            f.message.hits =
                static_cast<std::int32_t>(std::min<std::uint64_t>(found->second, INT32_MAX));
        }
    }
}

void story::look() {
    std::vector<csim_collision> list = collisions_of(sim_);
    for (; collisions_ < list.size(); collisions_++) {
        const csim_collision &c = list[collisions_];
        std::int32_t other = c.kind == CSIM_TERRAIN ? line_places_.at(c.other) : c.other;
        tell("collision", static_cast<std::int64_t>(c.t_us), met(c), c.id, other, c.x, c.y);
    }
    if (verdict_ == verdict_running && player_.finished()) {
        verdict_ = list.empty() ? verdict_passed : verdict_failed;
        reason_ = list.empty() ? "" : met_where(list.front());
        tell("verdict", now(), list.empty() ? "passed" : "failed: " + reason_);
    }
}

bool story::acts(const told_fault &f) const {
    return f.message.from_us <= now() && (f.message.to_us == no_end || now() < f.message.to_us);
}

viz::faults story::faults() {
    keep_hits();
    viz::faults message;
    message.t_us = now();
    message.run = run_;
    for (const told_fault &f : faults_) {
        message.items.push_back(f.message);
        message.items.back().active = acts(f) ? 1 : 0;
    }
    message.n = static_cast<std::int32_t>(message.items.size());
    return message;
}

std::vector<std::pair<std::int64_t, bool>> story::fault_key() const {
    std::vector<std::pair<std::int64_t, bool>> key;
    for (const told_fault &f : faults_) {
        key.emplace_back(f.message.to_us, acts(f));
    }
    return key;
}

std::set<std::int32_t> story::faulted() const {
    std::set<std::int32_t> copters;
    for (const told_fault &f : faults_) {
        if (f.message.object >= 0 && acts(f)) {
            copters.insert(f.message.object);
        }
    }
    return copters;
}

/* ---- Before it begins ---- */

std::map<std::int32_t, std::int32_t> line_places(const csim_scenario::scenario &s) {
    std::map<std::int32_t, std::int32_t> places;
    for (const csim_scenario::line &line : s.lines) {
        places[line.id] = 0;
    }
    std::int32_t next = 0;
    for (auto &place : places) {
        place.second = next++;
    }
    return places;
}

viz::world world_of(const csim_scenario::scenario &s, std::int32_t run) {
    viz::world world;
    world.run = run;
    world.version = 1;
    std::map<std::int32_t, std::int32_t> places = line_places(s);
    world.nseg = static_cast<std::int32_t>(places.size());
    world.seg.resize(places.size());
    for (const csim_scenario::line &line : s.lines) {
        world.seg[static_cast<std::size_t>(places[line.id])] = {rounded(line.x1), rounded(line.y1),
                                                                rounded(line.x2), rounded(line.y2)};
    }
    for (const csim_scenario::anchor &a : s.anchors) {
        world.anchors.push_back({a.id, {rounded(a.x), rounded(a.y), rounded(a.z)}});
    }
    world.nanchor = static_cast<std::int32_t>(world.anchors.size());
    world.npoly = 0;
    return world;
}

/* Letters, digits, "_" and "-", at most 64, as ids of cases are. */
static std::string id_of(const std::string &name) {
    std::string id;
    for (unsigned char c : name.substr(0, 64)) {
        id += std::isalnum(c) != 0 || c == '_' || c == '-' ? static_cast<char>(c) : '_';
    }
    return id.empty() ? "scenario" : id;
}

viz::case_info case_of(const csim_scenario::scenario &s) {
    viz::case_info info;
    info.case_id = id_of(s.name);
    info.property = "";
    info.seed = std::to_string(s.seed);
    info.code_version = CSIM_STREAM_VERSION;
    for (const csim_scenario::event &e : s.events) {
        viz::command command;
        /* The step that it acts on. */
        std::uint64_t late = e.t_us % s.dt_us;
        command.t_us = static_cast<std::int64_t>(late == 0 ? e.t_us : e.t_us - late + s.dt_us);
        command.index = static_cast<std::int32_t>(info.commands.size());
        words w = words_of(e);
        command.name = w.name;
        command.args = w.args;
        info.commands.push_back(std::move(command));
    }
    info.ncmd = info.ncmd_original = static_cast<std::int32_t>(info.commands.size());
    std::string step = number_text(1e-3 * static_cast<double>(s.dt_us));
    nlohmann::ordered_json params;
    params["summary"] = std::to_string(s.copters.size()) + " copters, " + step + " ms step";
    info.params = params.dump();
    return info;
}

std::int32_t copter_of(const std::string &probe) {
    std::size_t at = probe.compare(0, 8, "ITS_DATA") == 0 ? 8 : probe.find("Id");
    if (at == std::string::npos) {
        return -1;
    }
    at += at == 8 && probe[0] == 'I' ? 0 : 2;
    std::int64_t id = -1;
    for (; at < probe.size() && std::isdigit(static_cast<unsigned char>(probe[at])) != 0; at++) {
        id = std::min<std::int64_t>(std::max<std::int64_t>(id, 0) * 10 + (probe[at] - '0'),
                                    std::int64_t{INT32_MAX} + 1);
    }
    return id > INT32_MAX ? -1 : static_cast<std::int32_t>(id);
}

} // namespace coptersim_stream
