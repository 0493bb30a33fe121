// The handle behind csim.h: the world, and what is derived from it to be fast.
#pragma once

#include "broadcast.h"
#include "candidates.h"
#include "closeness.h"
#include "collision.h"
#include "columns.h"
#include "fc.h"
#include "hot_loops.h"
#include "params.h"
#include "pool.h"
#include "probes.h"
#include "ranging.h"
#include "terrain.h"

#include <memory>

namespace coptersim {

// Everything that decides how the simulation goes on, faults aside.
struct World {
    Params params;
    Columns copters;
    Ranging ranging;
    Terrain terrain;
    Broadcasts broadcasts;
    Collisions collisions;
    Closeness closeness;
    std::uint64_t time_us = 0;
    std::uint64_t its_count = 0, anchor_count = 0; // steps since the last broadcast, anchor step
    csim_run_state status = CSIM_RUNNING;
};

} // namespace coptersim

struct csim {
    csim(const csim_options &options, const coptersim::HotLoops &loops);
    ~csim();
    csim(const csim &) = delete;
    csim &operator=(const csim &) = delete;

    coptersim::World world;

    fc_context *faults;
    const bool owns_faults;
    const bool brute_force;
    const coptersim::HotLoops &hot;
    coptersim::Pool pool;
    const std::shared_ptr<const char> identity; // for snapshots
    csim_step_fn on_step = nullptr;
    void *step_user = nullptr;
    bool running = false; // inside csim_run

    // Derived: made by prepare, kept by the steps.
    bool renewed = true;     // copters, anchors or lines are others
    bool lists_stale = true; // something moved by itself, or parameters are others
    coptersim::Probes probes;
    coptersim::RiskTable risk, risk_before; // for broadcasts.now and .before
    coptersim::ContactTable contacts;
    coptersim::Column ax, ay;             // m/s^2, of the step
    std::vector<std::uint64_t> stamps;    // us, of this step's messages
    std::vector<std::uint8_t> has_ranges; // copter has active range probes
    std::vector<std::uint8_t> packet;     // as taken from a channel

    std::vector<std::uint8_t> private_flags; // copter has rows of its own

    // After changes from outside, before a step. Allocates what the steps need.
    void prepare();
    // Marks the copters with rows of their own.
    void note_privates();
    bool is_private(std::size_t copter) const {
        return private_flags[copter] != 0;
    }
};
