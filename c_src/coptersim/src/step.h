// One step of the simulation.
#pragma once

#include "risk.h"
#include "simulation.h"

namespace coptersim {

// What is the same in all steps of a run.
struct StepPlan {
    std::uint64_t dt_us;
    double dt; // s
    std::uint64_t its_div, anchor_div;
    Motion motion;
    Response response;
};

StepPlan make_plan(const Params &params, std::uint64_t dt_us, int its_div, int anchor_div);

// What is special about this one.
struct Step {
    std::uint64_t end; // us
    bool broadcast, anchors;
    std::size_t anchor; // index, when anchors
};

void run_step(csim &sim, const StepPlan &plan);

// ---- Parts of a step ----

// A: positions, attitudes believed, probes, messages.
void move_all(csim &sim, const StepPlan &plan);
void probe_copters(csim &sim, std::uint64_t end);
void fill_broadcast(csim &sim, const StepPlan &plan, const Step &step);

// How a copter perceives itself.
Own own_of(const World &world, std::size_t copter);

// B: station, attitude and correction of one copter after the other.
void look_around(csim &sim, const Step &step, std::size_t copter);
// The same with rows of its own.
void look_around_in(csim &sim, const PrivateMap &map, std::uint64_t now, std::size_t copter);
// All receivers with rows of their own, and what everybody sends them.
void look_around_privately(csim &sim, const StepPlan &plan, const Step &step);
void range_one(csim &sim, const Step &step, std::size_t copter);

// Whether a message can be true, given what was known of its sender (or nullptr), at the time it
// was heard.
bool is_plausible(const Params &params, const Heard &heard, std::uint64_t now, const Heard *known,
                  std::uint64_t known_at);

} // namespace coptersim
