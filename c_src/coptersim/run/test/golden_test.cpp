/* golden_test.cpp: the recorded scenarios of the original simulator, replayed.
 *
 *     golden_test coptersim_golden.json.gz COPTERSIM_RUN
 *
 * Given the 20 scenarios, when they are read, run in this process and written as a trace, then the
 * trace agrees with the recorded one as far as `compare` says, and the program COPTERSIM_RUN writes
 * the same bytes. */
#include "trace_of.hpp"

#include "../../test/gzip_file.h"
#include "check.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <unistd.h>

namespace {

using json = nlohmann::json;

struct deviation {
    double worst = 0;
    std::uint64_t at_us = 0;
    std::string what = "-";
    int compared = 0;
};

void compare_series(const json &got, const json &expected, const json &times,
                    std::uint64_t until_us, const std::string &what, deviation &d) {
    CHECK(got.size() == expected.size());
    for (std::size_t i = 0; i < expected.size() && i < got.size(); i++) {
        if (times[i].get<std::uint64_t>() > until_us) {
            break;
        }
        double difference = got[i].is_null() && expected[i].is_null()
                                ? 0.0
                                : std::fabs(got[i].get<double>() - expected[i].get<double>());
        d.compared++;
        if (!(difference <= d.worst)) {
            d.worst = difference;
            d.at_us = times[i];
            d.what = what;
        }
    }
}

deviation compare_traces(const json &got, const json &expected, std::uint64_t until_us) {
    deviation d;
    CHECK(got["format"] == expected["format"]);
    CHECK(got["copters"].size() == expected["copters"].size());
    const json &times = expected["t_us"];
    for (std::size_t i = 0; i < times.size() && times[i].get<std::uint64_t>() <= until_us; i++) {
        CHECK(i < got["t_us"].size() && got["t_us"][i] == times[i]);
    }
    for (const auto &[id, copter] : expected["copters"].items()) {
        const json &mine = got["copters"][id];
        for (const char *state : {"true", "perceived"}) {
            for (const auto &[quantity, series] : copter[state].items()) {
                compare_series(mine[state][quantity], series, times, until_us,
                               std::string(state) + "." + quantity + " of " + id, d);
            }
        }
        compare_series(mine["override"], copter["override"], times, until_us, "override of " + id,
                       d);
    }
    return d;
}

/* Kind, ids, point, and the time to a step; with the rest of what is known at the end. */
void compare_outcome(const json &got, const json &expected, std::uint64_t dt_us) {
    CHECK(got["collision"].is_null() == expected["collision"].is_null());
    for (const auto &[id, copter] : expected["copters"].items()) {
        const json &mine = got["copters"][id];
        CHECK(mine["override_steps"] == copter["override_steps"]);
        CHECK(std::fabs(mine["max_pos_error"].get<double>() -
                        copter["max_pos_error"].get<double>()) < 1e-6);
    }
    if (expected["collision"].is_null() || got["collision"].is_null()) {
        CHECK(got["end_t_us"] == expected["end_t_us"]);
        return;
    }
    const json &a = got["collision"], &b = expected["collision"];
    CHECK(a["kind"] == b["kind"] && a["ids"] == b["ids"]);
    double early = a["t_us"].get<double>() - b["t_us"].get<double>();
    CHECK(std::fabs(early) <= static_cast<double>(dt_us));
    if (early == 0) {
        CHECK(std::fabs(a["point"][0].get<double>() - b["point"][0].get<double>()) < 1e-6);
        CHECK(std::fabs(a["point"][1].get<double>() - b["point"][1].get<double>()) < 1e-6);
    }
}

std::string contents(const std::string &file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream all;
    all << in.rdbuf();
    return all.str();
}

std::string run_program(const std::string &program, const std::string &text) {
    char folder[] = "/tmp/golden_test_XXXXXX";
    if (mkdtemp(folder) == nullptr) {
        return "no folder";
    }
    std::string scenario = std::string(folder) + "/s.json", trace = std::string(folder) + "/t.json";
    std::ofstream(scenario, std::ios::binary) << text;
    std::string command = "'" + program + "' --out '" + trace + "' '" + scenario + "'";
    CHECK_INT(std::system(command.c_str()), 0);
    std::string result = contents(trace);
    std::remove(scenario.c_str());
    std::remove(trace.c_str());
    rmdir(folder);
    return result;
}

void replay(const json &entry, const std::string &program) {
    const json &scenario = entry["scenario"], &compare = entry["compare"];
    std::string name = scenario["name"], text = scenario.dump();
    std::uint64_t until_us = compare["until_us"];
    double tolerance = compare["tolerance"];
    coptersim_run::sim_owner sim = coptersim_run::new_simulation(1);
    std::string written = trace_of(sim.get(), text, name);
    if (written.empty()) {
        check_failures++;
        return;
    }
    json trace = json::parse(written);
    deviation d = compare_traces(trace, entry["trace"], until_us);
    std::printf("%-26s %7d values up to %6.2f s, worst deviation %.2e (%s at %.3f s)\n",
                name.c_str(), d.compared, 1e-6 * static_cast<double>(until_us), d.worst,
                d.what.c_str(), 1e-6 * static_cast<double>(d.at_us));
    CHECK(d.compared > 100 && d.worst <= tolerance);
    if (compare["collision_decided"].get<bool>()) {
        compare_outcome(trace, entry["trace"], scenario["dt_us"]);
    }
    CHECK(run_program(program, text) == written);
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: golden_test coptersim_golden.json.gz COPTERSIM_RUN\n");
        return 2;
    }
    json golden = json::parse(read_gzip(argv[1]));
    CHECK(golden["format"] == "coptersim-golden/1");
    CHECK_INT(golden["entries"].size(), 20);
    for (const json &entry : golden["entries"]) {
        replay(entry, argv[2]);
    }
    return CHECK_RESULT();
}
