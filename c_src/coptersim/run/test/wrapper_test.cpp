/* wrapper_test.cpp: programs written for the original simulator get the same bytes.
 *
 *     wrapper_test coptersim_golden.json.gz
 *
 * Given those recorded scenarios that the original's functions can express, when they are driven
 * through coptersim_wrapper.h and faultcheck_packet_wrapper.h, then the trace is the one of the
 * scenario. */
#include "trace_of.hpp"

#include "../../test/gzip_file.h"
#include "check.h"
#include "coptersim_wrapper.h"
#include "faultcheck_packet_wrapper.h"
#include "faultcheck_wrapper.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace {

using json = nlohmann::json;

/* Commands, and messages lost for ever. */
bool expressible(const json &scenario) {
    for (const json &event : scenario["events"]) {
        bool lost = event["type"] == "packet_fault" && event["model"] == "drop" &&
                    !event.contains("duration_us");
        if (event["type"] != "command" && !lost) {
            return false;
        }
    }
    return true;
}

void set_up(const json &scenario) {
    coptersim_resetCollision();
    csim_reset(csim_default());
    faultcheck_packet_removeAllFaults();
    for (const json &copter : scenario["copters"]) {
        coptersim_addCopter(copter["pos"][0], copter["pos"][1], copter["id"]);
    }
    for (const json &line : scenario["world"]["lines"]) {
        coptersim_addLineSegment(line["id"], line["p1"][0], line["p1"][1], line["p2"][0],
                                 line["p2"][1]);
    }
    for (const json &anchor : scenario["world"]["anchors"]) {
        const json &at = anchor["pos"];
        coptersim_addAnchor(anchor["id"], at[0], at[1], at[2]);
    }
}

void act(const json &event) {
    if (event["type"] == "packet_fault") {
        faultcheck_packet_addFaultDrop(event["channel"].get<std::string>().c_str(), 1000000);
        return;
    }
    CONTROL_INPUT_t input = {event["roll"], event["pitch"], event["yaw"], event["throttle"]};
    CHECK_INT(coptersim_setControlInput(event["copter"], input), 1);
}

/* A sample after each so many microseconds; the original ran on until then. */
std::string drive(const json &scenario) {
    set_up(scenario);
    csim_trace::recorder recorder(csim_default(), scenario["name"]);
    unsigned long dt = scenario["dt_us"], part = scenario["record"]["every_us"];
    unsigned long now = 0, duration = scenario["duration_us"];
    json events = scenario["events"];
    std::stable_sort(events.begin(), events.end(), [](const json &a, const json &b) {
        return a["t_us"].get<unsigned long>() < b["t_us"].get<unsigned long>();
    });
    std::size_t next = 0;
    recorder.sample();
    while (now < duration && coptersim_collisionOccured() == 0) {
        while (next < events.size() && events[next]["t_us"].get<unsigned long>() <= now) {
            act(events[next++]);
        }
        unsigned long stop = std::min(duration, (now / part + 1) * part);
        if (next < events.size()) {
            unsigned long event = events[next]["t_us"];
            stop = std::min(stop, (event + dt - 1) / dt * dt);
        }
        coptersim_runIterations((stop - now) / dt, dt, scenario["its_div"], scenario["anchor_div"]);
        now = stop;
        if (now % part == 0 && coptersim_collisionOccured() == 0) {
            recorder.sample();
        }
    }
    return json_of(recorder.finish());
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: wrapper_test coptersim_golden.json.gz\n");
        return 2;
    }
    json golden = json::parse(read_gzip(argv[1]));
    int driven = 0;
    for (const json &entry : golden["entries"]) {
        const json &scenario = entry["scenario"];
        if (!expressible(scenario)) {
            continue;
        }
        driven++;
        std::string name = scenario["name"];
        coptersim_run::sim_owner sim = coptersim_run::new_simulation(1);
        bool same = trace_of(sim.get(), scenario.dump(), name) == drive(scenario);
        std::printf("%-18s %s\n", name.c_str(), same ? "same bytes" : "differs");
        CHECK(same);
    }
    CHECK_INT(driven, 10);
    return CHECK_RESULT();
}
