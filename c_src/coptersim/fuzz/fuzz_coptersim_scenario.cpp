/* fuzz_coptersim_scenario.cpp: any bytes as a scenario file. What is refused has one line that says
 * why; what is accepted and small runs for a few steps, and its trace is JSON. */
#include "recorded_run.hpp"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace {

constexpr std::size_t most_copters = 20;
constexpr std::size_t most_lines = 50;
constexpr std::uint64_t most_steps = 30;

void expect(bool good) {
    if (!good) {
        std::abort();
    }
}

/* Errors of faults on their way are part of a run; nobody wants to read them here. */
void quiet(csim *sim) {
    fc_set_error_callback(
        csim_faults(sim), [](void *, const fc_error *) {}, nullptr);
}

void run(csim_scenario::scenario &s) {
    static const coptersim_run::sim_owner sim = coptersim_run::new_simulation(1);
    quiet(sim.get());
    s.duration_us = std::min(s.duration_us, most_steps * s.dt_us);
    std::string error, text;
    std::optional<csim_trace::trace> trace = coptersim_run::recorded_run(sim.get(), s, {}, error);
    expect(trace || !error.empty());
    if (trace) {
        csim_trace::write_json(*trace, [&text](std::string_view part) { text += part; });
        expect(nlohmann::json::accept(text));
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    csim_scenario::scenario s;
    std::string error;
    std::string_view text(reinterpret_cast<const char *>(data), size);
    if (!csim_scenario::read_scenario(text, "f", s, error)) {
        expect(error.compare(0, 2, "f:") == 0 && error.find('\n') == std::string::npos);
        return 0;
    }
    if (s.copters.size() <= most_copters && s.lines.size() <= most_lines &&
        s.anchors.size() <= most_lines) {
        run(s);
    }
    return 0;
}
