/* trace_of.hpp: the trace of a scenario, both as texts, run in this process. */
#ifndef TRACE_OF_HPP
#define TRACE_OF_HPP

#include "recorded_run.hpp"

#include <cstdio>
#include <string>

/* A trace as JSON. */
static inline std::string json_of(const csim_trace::trace &t) {
    std::string text;
    csim_trace::write_json(t, [&text](std::string_view part) { text += part; });
    return text;
}

/* Empty, with a line on standard error, when the scenario is refused. */
static inline std::string trace_of(csim *sim, const std::string &scenario,
                                   const std::string &name) {
    csim_scenario::scenario s;
    std::string error;
    std::optional<csim_trace::trace> recorded;
    if (csim_scenario::read_scenario(scenario, name, s, error)) {
        recorded = coptersim_run::recorded_run(sim, s, {}, error);
    }
    if (!recorded) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), error.c_str());
        return "";
    }
    return json_of(*recorded);
}

#endif
