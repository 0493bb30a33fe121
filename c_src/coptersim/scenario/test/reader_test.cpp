/* reader_test.cpp: what a scenario means, and what is said of those that mean nothing. */
#include "scenario.hpp"

#include "check.h"

#include <functional>

namespace {

using csim_scenario::scenario;

const std::string head = "{\"format\":\"coptersim-scenario/1\",\n\"dt_us\":5000,\n"
                         "\"duration_us\":1000000,\n";
const std::string one_copter = "\"copters\":[{\"id\":0,\"pos\":[0,0]}]";

/* The members that follow the copter, in line 5. */
std::string with(const std::string &members) {
    return head + one_copter + ",\n" + members + "}";
}

std::string with_event(const std::string &event) {
    return with("\"events\":[{\"t_us\":0," + event + "}]");
}

/* Given a text, its error is "f:LINE: ...PART...", one line. */
void refuse(const std::string &text, int line, const std::string &part) {
    scenario s;
    std::string error;
    bool read = csim_scenario::read_scenario(text, "f", s, error);
    std::string start = "f:" + std::to_string(line) + ": ";
    if (read || error.compare(0, start.size(), start) != 0 ||
        error.find(part) == std::string::npos || error.find('\n') != std::string::npos) {
        check_failures++;
        std::fprintf(stderr, "%s\n  gives  %s\n  not    %s...%s\n", text.substr(0, 400).c_str(),
                     read ? "no error" : error.c_str(), start.c_str(), part.c_str());
    }
}

scenario accept(const std::string &text) {
    scenario s;
    std::string error;
    if (!csim_scenario::read_scenario(text, "f", s, error)) {
        check_failures++;
        std::fprintf(stderr, "%s\n  gives  %s\n", text.substr(0, 400).c_str(), error.c_str());
    }
    return s;
}

void what_is_left_out() {
    scenario s = accept(head + one_copter + "}");
    CHECK_INT(s.dt_us, 5000);
    CHECK_INT(s.steps(), 200);
    CHECK_INT(s.its_div, 20);
    CHECK_INT(s.anchor_div, 20);
    CHECK_INT(s.seed, 1);
    CHECK_INT(s.record_every_us, 50000);
    CHECK(s.gains.empty() && s.configuration == "default");
    CHECK(s.copters.size() == 1 && s.copters[0].yaw == 0 && s.copters[0].vx == 0);
    CHECK(s.events.empty() && s.lines.empty() && s.settings.empty());
}

void comments_are_left_alone() {
    accept(with("\"class\":\"short\",\"description\":1,\"x_mine\":[{}],\"name\":\"n\""));
    accept(with_event("\"type\":\"command\",\"copter\":0,\"x_why\":\"because\""));
}

void everything_that_can_be_said() {
    scenario s = accept(
        with("\"its_div\":1,\"anchor_div\":5,\"altitude\":1.5,\"integrator\":\"exact\",\n"
             "\"halt_on_collision\":false,\"seed\":18446744073709551615,\n"
             "\"world\":{\"lines\":[{\"id\":1000,\"p1\":[1,2],\"p2\":[3,4]}],\n"
             "\"anchors\":[{\"id\":3,\"pos\":[1,2,3]}]},\n"
             "\"gains\":{\"pos_p\":0.5,\"max_tilt\":3},\"params\":{\"comfort_radius\":0.9},\n"
             "\"events\":[\n"
             "{\"t_us\":7,\"type\":\"command\",\"copter\":0,\"roll\":-1},\n"
             "{\"t_us\":0,\"type\":\"gains\",\"vel_p\":1},\n"
             "{\"t_us\":7,\"type\":\"clear_faults\",\"probe\":\"PxId0\"},\n"
             "{\"t_us\":0,\"type\":\"add_copter\",\"id\":5,\"pos\":[5,5],\"yaw\":90,\n"
             "\"vel\":[1,-1],\"gains\":{\"pos_d\":0.1}},\n"
             "{\"t_us\":9,\"type\":\"set_state\",\"id\":5,\"true\":{\"px\":2}},\n"
             "{\"t_us\":9,\"type\":\"remove_copter\",\"id\":5}],\n"
             "\"record\":{\"every_us\":25000}"));
    CHECK(s.seed == UINT64_MAX && s.its_div == 1 && s.anchor_div == 5);
    CHECK(s.record_every_us == 25000 && *s.gains.values[0] == 0.5 && *s.gains.values[10] == 3);
    CHECK(s.settings.size() == 4 && s.settings[0].value == 1.5 && s.settings[1].value == 1);
    CHECK(s.settings[2].value == 0 && s.settings[3].name == "comfort_radius");
    CHECK(s.lines.size() == 1 && s.lines[0].y2 == 4 && s.anchors[0].z == 3);
    CHECK_INT(s.events.size(), 6);
    /* sorted, and stable */
    CHECK(std::holds_alternative<csim_scenario::change_gains>(s.events[0].what));
    CHECK(std::holds_alternative<csim_scenario::copter>(s.events[1].what));
    CHECK(std::holds_alternative<csim_scenario::command>(s.events[2].what));
    CHECK(std::holds_alternative<csim_scenario::clear_faults>(s.events[3].what));
    const auto &added = std::get<csim_scenario::copter>(s.events[1].what);
    CHECK(added.id == 5 && added.vy == -1 && *added.gains.values[2] == 0.1);
}

void faults_by_name() {
    scenario s = accept(with(
        "\"events\":[\n"
        "{\"t_us\":0,\"type\":\"fault\",\"probe\":\"RollId0\",\"model\":\"offset\",\"value\":3},\n"
        "{\"t_us\":0,\"type\":\"fault\",\"probe\":\"PxId0\",\"model\":\"bitflip\",\"bit\":62,\n"
        "\"duration_us\":5000},\n"
        "{\"t_us\":0,\"type\":\"fault\",\"probe\":\"RangeId0Anch3\",\"model\":\"random_offset\",\n"
        "\"low\":0.5,\"high\":8,\"probability\":0.3},\n"
        "{\"t_us\":0,\"type\":\"fault\",\"probe\":\"YawId0\",\"model\":\"set_to\",\n"
        "\"value\":\"inf\"},\n"
        "{\"t_us\":0,\"type\":\"packet_fault\",\"channel\":\"ITS_DATA0\",\"model\":\"drop\"},\n"
        "{\"t_us\":0,\"type\":\"packet_fault\",\"channel\":\"ITS_DATA0\",\"model\":\"drop\",\n"
        "\"count\":3},\n"
        "{\"t_us\":0,\"type\":\"packet_fault\",\"channel\":\"ITS_DATA0\",\"model\":\"bitflip\",\n"
        "\"byte\":19,\"bit\":6},\n"
        "{\"t_us\":0,\"type\":\"packet_fault\",\"channel\":\"ITS_DATA0\",\"model\":\"repeat\",\n"
        "\"count\":2}]"));
    CHECK_INT(s.events.size(), 8);
}

/* As flights by hand are kept. */
void faults_with_windows() {
    scenario s = accept(with(
        "\"events\":[\n"
        "{\"t_us\":0,\"type\":\"fault\",\"probe\":\"RollId0\",\"model\":\"dropout\",\n"
        "\"params\":{\"probability\":0.5,\"mode\":\"zero\",\"x_why\":[]},\"delay_us\":200000,\n"
        "\"duration_us\":500000},\n"
        "{\"t_us\":0,\"type\":\"fault\",\"probe\":\"RangeId0Anch1\",\"model\":\"random_offset\",\n"
        "\"low\":0,\"params\":{\"high\":1},\"from_calls\":18446744073709551615,\n"
        "\"for_calls\":0,\"probability\":0.25,\"seed\":3},\n"
        "{\"t_us\":0,\"type\":\"packet_fault\",\"channel\":\"ITS_DATA0\",\"model\":\"field\",\n"
        "\"params\":{\"type\":\"f32\",\"apply\":\"spike\",\"probability\":0.5,\n"
        "\"height\":\"-inf\"},\"probability\":0.125},\n"
        "{\"t_us\":0,\"type\":\"packet_fault\",\"channel\":\"ITS_DATA0\",\"model\":\"repeat\",\n"
        "\"count\":10000,\"delay_us\":7},\n"
        "{\"t_us\":0,\"type\":\"packet_fault\",\"channel\":\"ITS_DATA0\",\"model\":\"extend\",\n"
        "\"params\":{\"n\":65536}}]"));
    CHECK_INT(s.events.size(), 5);
    if (s.events.size() != 5) {
        return;
    }
    auto fault_of = [&s](std::size_t i) {
        return std::get<csim_scenario::fault>(s.events[i].what);
    };
    csim_scenario::fault dropout = fault_of(0), scattered = fault_of(1), field = fault_of(2);
    CHECK(dropout.arguments.size() == 2 && dropout.arguments[0].number == 0.5);
    CHECK(dropout.delay_us == 200000 && *dropout.duration_us == 500000 && !dropout.probability);
    CHECK(!dropout.from_calls && !dropout.for_calls && !dropout.seed);
    CHECK(scattered.arguments.size() == 2 && *scattered.probability == 0.25);
    CHECK(*scattered.from_calls == UINT64_MAX && *scattered.for_calls == 0);
    CHECK(*scattered.seed == 3 && scattered.delay_us == 0 && !scattered.duration_us);
    CHECK(field.arguments.size() == 4 && *field.probability == 0.125);
    CHECK(fault_of(3).delay_us == 7 && !fault_of(3).duration_us);
}

/* Times count from that of the event, also when it is between two steps. */
void when_a_fault_acts() {
    csim_scenario::fault f{};
    csim_scenario::window w = csim_scenario::window_of(f, 12000, 15000);
    CHECK(w.from_us == 15000 && !w.to_us);
    f.duration_us = 10000;
    w = csim_scenario::window_of(f, 12000, 15000);
    CHECK(w.from_us == 15000 && *w.to_us == 22000);
    f.delay_us = 5000;
    w = csim_scenario::window_of(f, 12000, 15000);
    CHECK(w.from_us == 17000 && *w.to_us == 27000);
    f.delay_us = 0;
    f.duration_us = 1000;
    w = csim_scenario::window_of(f, 12000, 15000);
    CHECK(w.from_us == 15000 && *w.to_us == 15000);
}

void parameters_change_on_the_way() {
    scenario s = accept(with("\"events\":[{\"t_us\":5,\"type\":\"params\",\"gate\":\"median\",\n"
                             "\"comfort_radius\":0.5,\"halt_on_collision\":false,\"x_why\":1}]"));
    const auto &change = std::get<csim_scenario::change_params>(s.events.at(0).what);
    CHECK_INT(change.settings.size(), 3);
    CHECK(change.settings[1].name == "comfort_radius" && change.settings[1].value == 0.5);
    CHECK(change.settings[2].value == 0);
    /* in place of what the scenario says */
    std::string error;
    CHECK(csim_scenario::override_setting(s, "comfort_radius=1", error));
    CHECK_INT(change.settings.size(), 2);
    CHECK(csim_scenario::override_setting(s, "configuration=hardened", error));
    CHECK(change.settings.size() == 1 && change.settings[0].name == "halt_on_collision");
    CHECK(s.settings.empty());
}

void not_json() {
    refuse("", 1, "not JSON");
    refuse("not json", 1, "not JSON");
    refuse(head, 4, "not JSON");
    refuse(head + one_copter + "}}", 4, "not JSON");
    refuse(head + "\"copters\":[{\"id\":0,\"pos\":[NaN,0]}]}", 4, "not JSON");
    refuse(head + "\"copters\":[{\"id\":0,\"pos\":[1e999,0]}]}", 4, "1e999");
    refuse(std::string("\x89PNG\r\n\x1a\n\0\0\0", 11), 1, "not JSON");
    refuse(head + "\"name\":\"\xff\xfe\"}", 4, "not JSON");
    refuse(std::string(100000, '['), 1, "deeper");
    std::string whole = with("\"events\":[{\"t_us\":0,\"type\":\"command\",\"copter\":0}]");
    for (std::size_t length = 0; length < whole.size(); length++) {
        scenario s;
        std::string error;
        CHECK(!csim_scenario::read_scenario(whole.substr(0, length), "f", s, error));
    }
}

void wrong_shape() {
    refuse("[]", 1, "an object expected");
    refuse("{}", 1, "format is missing");
    refuse("{\"format\":\"coptersim-scenario/2\"}", 1, "coptersim-scenario/1");
    refuse("{\"format\":\"coptersim-scenario/1\"}", 1, "dt_us is missing");
    refuse(head + "\"x\":1}", 1, "copters is missing");
    refuse(with("\"dt_us\":1"), 5, "twice");
    refuse(with("\"its_dvi\":1"), 5, "its_dvi: unknown; known here: ");
    refuse(with("\"record\":{\"every\":1}"), 5, "record.every_us is missing");
    refuse(with("\"world\":{\"line\":[]}"), 5, "world.line: unknown");
    refuse(with("\"events\":{}"), 5, "events: an array expected, not an object");
    refuse(with("\"name\":7"), 5, "name: a text expected, not a number");
    refuse(with("\"halt_on_collision\":2"), 5, "true or false expected");
    refuse(with("\"integrator\":\"rk4\""), 5, "v1");
    refuse(with("\"altitude\":\"high\""), 5, "a number expected");
    refuse(with("\"params\":{\"comfort\":1}"), 5, "params.comfort: unknown parameter");
    refuse(with("\"params\":{\"comfort_radius\":-1}"), 5, "from 0 to");
    refuse(with("\"params\":{\"configuration\":\"\"}"), 5, "default or hardened expected");
    refuse(with("\"params\":{\"pos_p\":1}"), 5, "belongs into gains");
    refuse(with("\"gains\":{\"pos_q\":1}"), 5, "gains.pos_q: unknown");
}

void wrong_values() {
    refuse("{\"format\":\"coptersim-scenario/1\",\n\"dt_us\":0}", 2,
           "dt_us: a whole number from 1");
    refuse("{\"format\":\"coptersim-scenario/1\",\n\"dt_us\":-5}", 2, "dt_us: a whole number");
    refuse("{\"format\":\"coptersim-scenario/1\",\n\"dt_us\":0.5}", 2, "dt_us: a whole number");
    refuse("{\"format\":\"coptersim-scenario/1\",\"dt_us\":5,\n\"duration_us\":-1\n}", 2,
           "duration_us: a whole number");
    refuse(head + "\"copters\":[\n{\"id\":-1,\"pos\":[0,0]}]}", 5, "copters[0].id");
    refuse(head + "\"copters\":[\n{\"id\":2147483648,\"pos\":[0,0]}]}", 5, "copters[0].id");
    refuse(head + "\"copters\":[{\"id\":1,\"pos\":[0,0]},\n{\"id\":1,\"pos\":[1,0]}]}", 5,
           "the id 1 is there twice");
    refuse(head + "\"copters\":[{\"id\":1,\"pos\":[0]}]}", 4, "2 numbers expected, not of 1");
    refuse(head + "\"copters\":[{\"id\":1,\"pos\":[0,\"1\"]}]}", 4, "a number expected");
    refuse(head + "\"copters\":[{\"id\":1}]}", 4, "copters[0].pos is missing");
    refuse(with("\"world\":{\"anchors\":[{\"id\":1,\"pos\":[0,0,0]},\n"
                "{\"id\":1,\"pos\":[0,0,0]}]}"),
           6, "world.anchors: the id 1 is there twice");
    refuse(with("\"world\":{\"lines\":[{\"id\":1,\"p1\":[0,0],\"p2\":[0,0]},\n"
                "{\"id\":1,\"p1\":[0,0],\"p2\":[0,0]}]}"),
           6, "world.lines: the id 1 is there twice");
}

void wrong_events() {
    refuse(with("\"events\":[{\"type\":\"command\"}]"), 5, "events[0].t_us is missing");
    refuse(with("\"events\":[{\"t_us\":-1,\"type\":\"command\"}]"), 5, "events[0].t_us");
    refuse(with_event("\"type\":\"explode\""), 5, "\"explode\" is unknown; known: command");
    refuse(with_event("\"type\":\"command\",\"copter\":1"), 5, "there is no copter 1");
    refuse(with_event("\"type\":\"command\",\"copter\":0,\"rol\":1"), 5, "rol: unknown");
    refuse(with("\"events\":[{\"t_us\":0,\"type\":\"remove_copter\",\"id\":0},\n"
                "{\"t_us\":0,\"type\":\"command\",\"copter\":0}]"),
           6, "there is no copter 0");
    refuse(with_event("\"type\":\"set_state\",\"id\":0,\"true\":{\"p\":1}"), 5, "true.p: unknown");
    std::string fault = "\"type\":\"fault\",\"model\":\"offset\",";
    refuse(with_event(fault + "\"probe\":\"Px0\",\"value\":1"), 5, "not a name of a simulation");
    refuse(with_event(fault + "\"probe\":\"PxId00\",\"value\":1"), 5, "not a name");
    refuse(with_event(fault + "\"probe\":\"PxId0\""), 5, "events[0]: ");
    refuse(with_event(fault + "\"probe\":\"PxId0\",\"value\":[]"), 5, "events[0].value");
    refuse(with_event(fault + "\"probe\":\"PxId0\",\"value\":1,\"size\":2"), 5, "size");
    refuse(with_event(fault + "\"probe\":\"PxId0\",\"value\":1,\"probability\":2"), 5,
           "events[0]: ");
    refuse(with_event("\"type\":\"fault\",\"probe\":\"PxId0\",\"model\":\"offsett\",\"value\":1"),
           5, "offsett");
    refuse(with_event("\"type\":\"packet_fault\",\"channel\":\"ITS\",\"model\":\"drop\""), 5,
           "not a name");
}

void wrong_windows() {
    std::string fault = "\"type\":\"fault\",\"model\":\"offset\",\"probe\":\"PxId0\",";
    for (const char *name : {"delay_us", "duration_us", "from_calls", "for_calls"}) {
        std::string member = "\"value\":1,\n\"" + std::string(name) + "\":";
        std::string expected = "events[0]." + std::string(name) + ": a whole number";
        for (const char *bad : {"-1", "0.5", "1e300", "\"1\"", "\"nan\"", "null", "[]", "true"}) {
            refuse(with_event(fault + member + bad), 6, expected);
        }
        refuse(with_event(fault + member + "NaN"), 6, "not JSON");
    }
    refuse(with_event(fault + "\"value\":1,\"for_calls\":9223372036854775808"), 5, "for_calls");
    refuse(with_event(fault + "\"value\":1,\"delay_us\":9007199254740993"), 5, "delay_us");
    for (const char *both :
         {"\"delay_us\":0,\"from_calls\":0", "\"delay_us\":1,\"for_calls\":1",
          "\"duration_us\":1,\"from_calls\":1", "\"duration_us\":1,\"for_calls\":1"}) {
        refuse(with_event(fault + "\"value\":1," + both), 5,
               "events[0]: either delay_us and duration_us, or from_calls and for_calls");
    }
    refuse(with_event(fault + "\"params\":[1]"), 5, "events[0].params: an object expected");
    refuse(with_event(fault + "\"params\":{}"), 5, "model offset needs value");
    refuse(with_event(fault + "\"params\":{\n\"value\":[]}"), 6, "events[0].params.value");
    refuse(with_event(fault + "\"params\":{\"value\":1,\"size\":2}"), 5, "\"size\"");
    refuse(with_event(fault + "\"value\":1,\"params\":{\"value\":1}"), 5, "value is given twice");
    refuse(with_event(fault + "\"value\":1,\"for_cals\":2"), 5, "\"for_cals\"");
}

/* What would stop the simulated clock. */
void too_many_packets() {
    std::string fault = "\"type\":\"packet_fault\",\"channel\":\"ITS_DATA0\",\"model\":";
    refuse(with_event(fault + "\"repeat\",\n\"count\":10001"), 6,
           "events[0].count: 10000 are the most");
    refuse(with_event(fault + "\"repeat\",\"params\":{\n\"n\":9007199254740992}"), 6,
           "events[0].params.n: 10000 are the most");
    refuse(with_event(fault + "\"extend\",\n\"count\":65537"), 6,
           "events[0].count: 65536 are the most");
    refuse(with_event(fault + "\"extend\",\n\"count\":\"inf\""), 6,
           "events[0].count: 65536 are the most");
}

void wrong_parameters() {
    std::string event = "\"type\":\"params\",\n";
    refuse(with_event(event + "\"comfort\":1"), 6, "events[0].comfort: unknown parameter");
    refuse(with_event(event + "\"pos_p\":1"), 6,
           "events[0].pos_p: belongs into an event of type gains");
    refuse(with_event(event + "\"comfort_radius\":-1"), 6, "comfort_radius: a number from 0 to");
    refuse(with_event(event + "\"comfort_radius\":\"nan\""), 6, "a number expected");
    refuse(with_event(event + "\"gate\":\"none\""), 6, "median");
    refuse(with_event(event + "\"configuration\":\"default\""), 6, "unknown parameter");
}

void too_many() {
    std::string text = head + "\"copters\":[";
    for (int i = 0; i <= 100000; i++) {
        text +=
            (i == 0 ? "" : ",") + std::string("{\"id\":") + std::to_string(i) + ",\"pos\":[0,0]}";
    }
    refuse(text + "]}", 4, "copters: 100001 items, at most 100000");
}

void overrides() {
    std::string error;
    scenario s = accept(with("\"events\":[{\"t_us\":5,\"type\":\"gains\",\"pos_p\":2}]"));
    CHECK(csim_scenario::override_setting(s, "pos_p=1.5", error));
    CHECK(*s.gains.values[0] == 1.5);
    CHECK(std::get<csim_scenario::change_gains>(s.events[0].what).gains.empty());
    CHECK(csim_scenario::override_setting(s, "its_div=7", error) && s.its_div == 7);
    CHECK(csim_scenario::override_setting(s, "integrator=euler", error));
    CHECK(s.settings.size() == 1 && s.settings[0].value == 2);
    CHECK(csim_scenario::override_setting(s, "comfort_radius=1", error));
    CHECK(csim_scenario::override_setting(s, "configuration=hardened", error));
    CHECK(s.configuration == "hardened" && s.settings.size() == 1 && s.gains.empty());
    for (const char *bad :
         {"pos_p", "=1", "pos_p=", "pos_p=x", "nothing=1", "its_div=-1", "its_div=1.5",
          "integrator=rk4", "configuration=x", "comfort_radius=[1]"}) {
        error.clear();
        CHECK(!csim_scenario::override_setting(s, bad, error) && !error.empty());
    }
}

} // namespace

int main() {
    what_is_left_out();
    comments_are_left_alone();
    everything_that_can_be_said();
    faults_by_name();
    faults_with_windows();
    when_a_fault_acts();
    parameters_change_on_the_way();
    not_json();
    wrong_shape();
    wrong_values();
    wrong_events();
    wrong_windows();
    too_many_packets();
    wrong_parameters();
    too_many();
    overrides();
    return CHECK_RESULT();
}
