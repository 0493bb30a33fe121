/* streamed_run_test.cpp: what is told of a flight, when, and that it is the same each time. */
#include "streamed_run.hpp"

#include "check.h"
#include "recorded_run.hpp"
#include "viz/frame.hpp"
#include "viz/status.hpp"

#include <cstring>
#include <set>

using namespace coptersim_stream;

namespace {

struct told {
    std::uint64_t t_us;
    std::string channel, bytes;
};

class memory : public sink {
  public:
    bool put(std::uint64_t t_us, const char *channel, std::string_view bytes,
             std::string &error) override {
        all.push_back({t_us, channel, std::string(bytes)});
        error = "full";
        return all.size() < room;
    }
    /* The messages of a channel, decoded. */
    template <class M> std::vector<M> of(const char *channel) const {
        std::vector<M> messages;
        for (const told &t : all) {
            if (t.channel == channel) {
                messages.emplace_back();
                int size = static_cast<int>(t.bytes.size());
                CHECK_INT(messages.back().decode(t.bytes.data(), 0, size), size);
            }
        }
        return messages;
    }
    std::vector<told> all;
    std::size_t room = SIZE_MAX;
};

const char *const flight =
    R"({"format": "coptersim-scenario/1", "name": "a flight!", "dt_us": 3000,
        "duration_us": 2500000, "seed": 5,
        "world": {"lines": [{"id": 9, "p1": [0, 50], "p2": [1, 50]},
                            {"id": 2, "p1": [0, 60], "p2": [1, 60]}],
                  "anchors": [{"id": 4, "pos": [-8, -5, 1]}]},
        "copters": [{"id": 1, "pos": [20, 0]}, {"id": 0, "pos": [0, 0]}],
        "events": [
          {"t_us": 100000, "type": "command", "copter": 1, "roll": 0.1},
          {"t_us": 300000, "type": "fault", "probe": "PxId1", "model": "offset", "value": 0.1,
           "duration_us": 300000},
          {"t_us": 900000, "type": "packet_fault", "channel": "ITS_DATA0", "model": "drop"},
          {"t_us": 1500000, "type": "clear_faults", "channel": "ITS_DATA0"}]})";

csim_scenario::scenario scenario_of(const char *text) {
    csim_scenario::scenario s;
    std::string error;
    CHECK(csim_scenario::read_scenario(text, "f", s, error));
    return s;
}

memory tell(const csim_scenario::scenario &s, outcome &result, double speed = 1) {
    coptersim_run::sim_owner sim = coptersim_run::new_simulation(1);
    memory to;
    telling how;
    how.observer = default_observer(s);
    how.pace_us = static_cast<std::uint64_t>(1e6 * speed);
    how.frame_us = frame_interval(s.dt_us, speed);
    std::string error;
    CHECK(streamed_run(sim.get(), s, {{&to, how}}, {}, result, error));
    return to;
}

void the_same_bytes_each_time() {
    csim_scenario::scenario s = scenario_of(flight);
    outcome result;
    memory first = tell(s, result), second = tell(s, result);
    CHECK(first.all.size() > 100 && first.all.size() == second.all.size());
    for (std::size_t i = 0; i < first.all.size(); i++) {
        CHECK(first.all[i].bytes == second.all[i].bytes && first.all[i].t_us == second.all[i].t_us);
    }
}

void a_frame_every_18_ms_and_at_each_event() {
    /* 18 ms are the whole steps of 3 ms in 20 ms; events act on the first step after their time */
    outcome result;
    std::vector<viz::frame> frames = tell(scenario_of(flight), result).of<viz::frame>("VIZ_FRAME");
    std::set<std::int64_t> times;
    std::int64_t before = 0;
    for (std::size_t i = 0; i < frames.size(); i++) {
        CHECK_INT(frames[i].seq, static_cast<int>(i));
        CHECK(i == 0 || (frames[i].t_us > before && frames[i].t_us <= before + 18000));
        before = frames[i].t_us;
        times.insert(before);
    }
    CHECK_INT(*times.begin(), 0);
    CHECK_INT(*times.rbegin(), 2499000); /* 833 steps */
    for (std::int64_t event : {102000, 300000, 900000, 1500000}) {
        CHECK(times.count(event) == 1);
    }
    CHECK_INT(frame_interval(5000, 1), 20000);
    CHECK_INT(frame_interval(30000, 1), 30000);
    CHECK_INT(frame_interval(5000, 0.1), 5000);
    CHECK_INT(frame_interval(5000, 20), 400000);
}

void each_kind_in_its_interval() {
    outcome result;
    memory to = tell(scenario_of(flight), result);
    std::map<std::string, int> counts;
    for (const told &t : to.all) {
        counts[t.channel]++;
    }
    CHECK_INT(counts["VIZ_RISK"], counts["VIZ_FRAME"]);
    CHECK_INT(counts["VIZ_CASE"], 3); /* at 0, 1 and 2 s */
    CHECK_INT(counts["VIZ_WORLD"], 3);
    CHECK(counts["VIZ_RANGE"] >= 20 && counts["VIZ_RANGE"] <= 26);
    CHECK(counts["VIZ_STATUS"] >= 11 && counts["VIZ_STATUS"] <= 14);
    CHECK_INT(counts["VIZ_EVENT"], 4 + 2 + 1); /* commands, faults, verdict */
}

void faults_are_told_with_their_times() {
    outcome result;
    std::vector<viz::faults> told = tell(scenario_of(flight), result).of<viz::faults>("VIZ_FAULTS");
    const viz::faults &last = told.back();
    CHECK_INT(told.front().n, 0);
    CHECK_INT(last.n, 2);
    const viz::fault &offset = last.items.at(0), &drop = last.items.at(1);
    CHECK(offset.probe == "PxId1" && offset.type == "offset" && offset.params == "{\"value\":0.1}");
    CHECK_INT(offset.object, 1);
    CHECK_INT(offset.from_us, 300000);
    CHECK_INT(offset.to_us, 600000);
    CHECK_INT(offset.active, 0);
    CHECK_INT(offset.hits, 100); /* one call in each step of 3 ms */
    CHECK(drop.probe == "ITS_DATA0" && drop.type == "drop" && drop.object == 0);
    CHECK_INT(drop.from_us, 900000);
    CHECK_INT(drop.to_us, 1500000);
    CHECK(drop.hits > 0);
    bool was_active = false, was_open = false;
    for (const viz::faults &f : told) {
        was_active = was_active || (f.n == 1 && f.items[0].active == 1);
        was_open = was_open || (f.n == 2 && f.items[1].active == 1 && f.items[1].to_us == -1);
    }
    CHECK(was_active && was_open);
    for (const viz::frame &f : tell(scenario_of(flight), result).of<viz::frame>("VIZ_FRAME")) {
        CHECK_INT((f.objects.at(0).flags & 4) != 0, f.t_us >= 900000 && f.t_us < 1500000);
        CHECK_INT((f.objects.at(1).flags & 4) != 0, f.t_us >= 300000 && f.t_us < 600000);
    }
}

void case_and_world() {
    outcome result;
    memory to = tell(scenario_of(flight), result);
    viz::case_info info = to.of<viz::case_info>("VIZ_CASE").at(0);
    CHECK(info.case_id == "a_flight_" && info.seed == "5");
    CHECK_INT(info.ncmd, 4);
    CHECK_INT(info.commands.at(0).t_us, 102000);
    CHECK(info.commands.at(0).name == "command" && info.commands.at(0).args == "1, 0.1, 0, 0, 0");
    CHECK(info.params == "{\"summary\":\"2 copters, 3 ms step\"}");
    viz::world world = to.of<viz::world>("VIZ_WORLD").at(0);
    CHECK_INT(world.nseg, 2);
    CHECK(world.seg.at(0).at(1) == 60.0F); /* line 2 before line 9 */
    CHECK(world.seg.at(1).at(1) == 50.0F);
    CHECK_INT(world.anchors.at(0).id, 4);
    CHECK(world.anchors.at(0).pos[0] == -8.0F);
}

void events_are_numbered_and_end_with_the_verdict() {
    outcome result;
    std::vector<viz::event> events = tell(scenario_of(flight), result).of<viz::event>("VIZ_EVENT");
    for (std::size_t i = 0; i < events.size(); i++) {
        CHECK_INT(events[i].seq, static_cast<int>(i));
    }
    CHECK(events.at(1).kind == "command" && events.at(1).a == 1);
    CHECK(events.at(2).kind == "fault" && events.at(2).a == 1);
    CHECK(events.back().kind == "verdict" && events.back().text == "passed");
    CHECK(result.how == verdict_passed && result.reason.empty());
}

const char *const crash =
    R"({"format": "coptersim-scenario/1", "name": "", "dt_us": 5000, "duration_us": 9000000,
        "world": {"lines": [{"id": 7, "p1": [0.3, -1], "p2": [0.3, 1]}]},
        "copters": [{"id": 3, "pos": [0, 0]}]})";

void a_collision_ends_it() {
    outcome result;
    memory to = tell(scenario_of(crash), result);
    CHECK(result.how == verdict_failed);
    CHECK(result.reason.find("copter 3 met terrain line 7 at 0.005000 s") == 0);
    std::vector<viz::event> events = to.of<viz::event>("VIZ_EVENT");
    CHECK_INT(static_cast<int>(events.size()), 2);
    CHECK(events.at(0).kind == "collision" && events.at(0).t_us == 5000);
    CHECK_INT(events.at(0).a, 3);
    CHECK_INT(events.at(0).b, 0); /* the place of line 7 */
    CHECK(events.at(0).x == 0.3F);
    viz::status status = to.of<viz::status>("VIZ_STATUS").back();
    CHECK_INT(status.verdict, verdict_failed);
    CHECK(status.message == result.reason);
    CHECK_INT(to.of<viz::frame>("VIZ_FRAME").back().objects.at(0).flags & 1, 1);
    CHECK(to.of<viz::case_info>("VIZ_CASE").at(0).case_id == "scenario");
}

void a_sink_that_fails_ends_it() {
    csim_scenario::scenario s = scenario_of(flight);
    coptersim_run::sim_owner sim = coptersim_run::new_simulation(1);
    memory to;
    to.room = 20;
    outcome result;
    std::string error;
    CHECK(!streamed_run(sim.get(), s, {{&to, telling{}}}, {}, result, error));
    CHECK(error == "full");
}

void who_meets_a_fault_is_observed() {
    CHECK_INT(default_observer(scenario_of(flight)), 1);
    CHECK_INT(default_observer(scenario_of(crash)), 3);
    csim_scenario::scenario empty = scenario_of(
        R"({"format": "coptersim-scenario/1", "dt_us": 1, "duration_us": 1, "copters": []})");
    CHECK_INT(default_observer(empty), -1);
}

} // namespace

int main() {
    the_same_bytes_each_time();
    a_frame_every_18_ms_and_at_each_event();
    each_kind_in_its_interval();
    faults_are_told_with_their_times();
    case_and_world();
    events_are_numbered_and_end_with_the_verdict();
    a_collision_ends_it();
    a_sink_that_fails_ends_it();
    who_meets_a_fault_is_observed();
    return CHECK_RESULT();
}
