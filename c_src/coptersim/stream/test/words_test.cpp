/* words_test.cpp: events of a scenario in words, and to whom a probe belongs. */
#include "words.hpp"

#include "check.h"
#include "story.hpp"

using namespace coptersim_stream;

namespace {

/* The text of the only event of a scenario. */
std::string text_of(const std::string &event) {
    csim_scenario::scenario s;
    std::string error;
    std::string scenario =
        R"({"format": "coptersim-scenario/1", "dt_us": 5000, "duration_us": 1000000,
            "copters": [{"id": 0, "pos": [0, 0]}], "events": [)" +
        event + "]}";
    if (!csim_scenario::read_scenario(scenario, "f", s, error)) {
        return error;
    }
    return words_of(s.events.at(0)).text();
}

void check_text(const char *event, const char *expected) {
    std::string text = text_of(event);
    if (text != expected) {
        std::fprintf(stderr, "%s\n  is %s\n  expected %s\n", event, text.c_str(), expected);
        CHECK(false);
    }
}

void every_type_has_words() {
    check_text(R"({"t_us": 0, "type": "command", "copter": 0, "roll": 0.3})",
               "command(0, 0.3, 0, 0, 0)");
    check_text(R"({"t_us": 0, "type": "gains", "pos_p": 0.5, "max_tilt": 20})",
               "gains(all, #{pos_p => 0.5, max_tilt => 20})");
    check_text(R"({"t_us": 0, "type": "gains", "copter": 0, "pos_p": 1})",
               "gains(0, #{pos_p => 1})");
    check_text(R"({"t_us": 0, "type": "fault", "probe": "PxId0", "model": "offset", "value": "inf",
                   "probability": 0.5, "seed": 7, "duration_us": 20000})",
               "fault(\"PxId0\", \"offset\", "
               "\"{\\\"value\\\":\\\"inf\\\",\\\"probability\\\":0.5,\\\"seed\\\":7}\", 20000)");
    check_text(R"({"t_us": 0, "type": "params", "comfort_radius": 0.5, "altitude": 2})",
               "params(#{comfort_radius => 0.5, altitude => 2})");
    check_text(R"({"t_us": 0, "type": "fault", "probe": "PxId0", "model": "offset", "value": 1,
                   "from_calls": 3, "for_calls": 2})",
               "fault(\"PxId0\", \"offset\", "
               "\"{\\\"value\\\":1,\\\"from_calls\\\":3,\\\"for_calls\\\":2}\", forever)");
    check_text(R"({"t_us": 0, "type": "packet_fault", "channel": "ITS_DATA0", "model": "field",
                   "probability": 0.5, "delay_us": 7,
                   "params": {"apply": "spike", "height": 1, "probability": 1}})",
               "packet_fault(\"ITS_DATA0\", \"field\", "
               "\"{\\\"params\\\":{\\\"apply\\\":\\\"spike\\\",\\\"height\\\":1,"
               "\\\"probability\\\":1},\\\"probability\\\":0.5,\\\"delay_us\\\":7}\", "
               "forever)");
    check_text(R"({"t_us": 0, "type": "packet_fault", "channel": "ITS_DATA0", "model": "drop"})",
               "packet_fault(\"ITS_DATA0\", \"drop\", \"{}\", forever)");
    check_text(R"({"t_us": 0, "type": "clear_faults"})", "clear_faults(all)");
    check_text(R"({"t_us": 0, "type": "clear_faults", "probe": "PxId0"})",
               "clear_faults(\"PxId0\")");
    check_text(R"({"t_us": 0, "type": "add_copter", "id": 5, "pos": [1, -2.5], "yaw": 90})",
               "add_copter(5, 1, -2.5, 90)");
    check_text(R"({"t_us": 0, "type": "remove_copter", "id": 0})", "remove_copter(0)");
    check_text(R"({"t_us": 0, "type": "set_state", "id": 0, "perceived": {"px": 1e-3}})",
               "set_state(0, #{}, #{px => 0.001})");
}

void probes_belong_to_copters() {
    CHECK_INT(copter_of("PxId3"), 3);
    CHECK_INT(copter_of("RangeId12Anch4"), 12);
    CHECK_INT(copter_of("ITS_DATA0"), 0);
    CHECK_INT(copter_of("PxId2147483647"), 2147483647);
    CHECK_INT(copter_of("PxId2147483648"), -1);
    CHECK_INT(copter_of("PxId"), -1);
    CHECK_INT(copter_of("other"), -1);
}

void numbers_are_short() {
    CHECK(number_text(5) == "5");
    CHECK(number_text(-0.5) == "-0.5");
    CHECK(number_text(1e300) == "1e+300");
}

} // namespace

int main() {
    every_type_has_words();
    probes_belong_to_copters();
    numbers_are_short();
    return CHECK_RESULT();
}
