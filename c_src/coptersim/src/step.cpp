#include "step.h"

#include "attitude.h"
#include "position.h"

#include <algorithm>
#include <cstring>

namespace coptersim {

namespace {

constexpr std::size_t kPart = 32;               // copters that are worth a thread
constexpr std::uint64_t kLongestLists = 200000; // us, that lists are made for

struct Range {
    std::size_t begin, end; // multiples of kLanes
};

// Calls work(range) for parts of all copters, on as many threads as it is worth.
template <class Work> void in_parts(csim &sim, const Work &work) {
    const std::size_t all = padded(sim.world.copters.size());
    const auto threads = static_cast<std::size_t>(sim.pool.threads());
    const std::size_t parts = std::min(threads, all / kPart);
    if (parts < 2) {
        work(Range{0, all});
        return;
    }
    const std::size_t size = padded((all + parts - 1) / parts);
    sim.pool.run([&](int part) {
        const std::size_t begin = std::min(all, static_cast<std::size_t>(part) * size);
        const std::size_t end = std::min(all, begin + size);
        if (begin < end)
            work(Range{begin, end});
    });
}

void move_state(const csim &sim, const Motion &motion, Range range, StateColumns *state) {
    sim.hot.move(range.begin, range.end, motion, state->px.data(), state->vx.data(), sim.ax.data());
    sim.hot.move(range.begin, range.end, motion, state->py.data(), state->vy.data(), sim.ay.data());
}

void limit_state(const Params &params, double dt, Range range, std::size_t count,
                 StateColumns *state) {
    for (std::size_t i = range.begin; i < std::min(range.end, count); ++i)
        limit_velocity(params, dt, state->roll[i], state->pitch[i], &state->vx[i], &state->vy[i]);
}

void copy(const Column &from, Range range, Column *to) {
    std::copy(from.begin() + static_cast<std::ptrdiff_t>(range.begin),
              from.begin() + static_cast<std::ptrdiff_t>(range.end),
              to->begin() + static_cast<std::ptrdiff_t>(range.begin));
}

// Copters whose belief needs a trigonometry of its own.
template <class F> void each_with_own_attitude(Columns &copters, Range range, F f) {
    for (std::size_t i = range.begin; i < std::min(range.end, copters.size()); ++i)
        if (copters.own_attitude[i])
            f(i);
}

void accelerate_belief(csim &sim, Range range) {
    const StateColumns &belief = sim.world.copters.belief;
    each_with_own_attitude(sim.world.copters, range, [&](std::size_t i) {
        const Acceleration<double> a = acceleration(belief.roll[i] + belief.e_r[i],
                                                    belief.pitch[i] + belief.e_p[i], belief.yaw[i]);
        sim.ax[i] = a.x;
        sim.ay[i] = a.y;
    });
}

void move_part(csim &sim, const StepPlan &plan, Range range) {
    Columns &copters = sim.world.copters;
    StateColumns &truth = copters.truth, &belief = copters.belief;
    const bool limits = limits_velocity(sim.world.params);
    sim.hot.accelerate(range.begin, range.end,
                       {truth.roll.data(), truth.pitch.data(), truth.yaw.data(), truth.e_r.data(),
                        truth.e_p.data()},
                       sim.ax.data(), sim.ay.data());
    move_state(sim, plan.motion, range, &truth);
    accelerate_belief(sim, range);
    move_state(sim, plan.motion, range, &belief);
    if (limits) {
        limit_state(sim.world.params, plan.dt, range, copters.size(), &truth);
        limit_state(sim.world.params, plan.dt, range, copters.size(), &belief);
    }
    copy(truth.roll, range, &belief.roll);
    copy(truth.pitch, range, &belief.pitch);
    copy(truth.yaw, range, &belief.yaw);
    each_with_own_attitude(copters, range, [&](std::size_t i) {
        copters.own_attitude[i] = belief.e_r[i] != 0 || belief.e_p[i] != 0;
    });
}

void respond_state(csim &sim, const Response &response, Range range, StateColumns *state) {
    const Columns &c = sim.world.copters;
    const bool far = sim.hot.respond(range.begin, range.end, response,
                                     {c.roll.data(), c.pitch.data(), c.yaw.data()},
                                     state->roll.data(), state->pitch.data(), state->yaw.data());
    if (!far)
        return;
    for (Column *angles : {&state->roll, &state->pitch, &state->yaw})
        for (std::size_t i = range.begin; i < range.end; ++i)
            (*angles)[i] = wrap((*angles)[i]);
}

void finish_part(csim &sim, const StepPlan &plan, const Step &step, Range range) {
    Columns &c = sim.world.copters;
    respond_state(sim, plan.response, range, &c.truth);
    respond_state(sim, plan.response, range, &c.belief);
    if (step.anchors)
        for (std::size_t i = range.begin; i < std::min(range.end, c.size()); ++i)
            range_one(sim, step, i);
    sim.hot.track(range.begin, range.end, c.truth.px.data(), c.truth.py.data(), c.belief.px.data(),
                  c.belief.py.data(), c.max_error2.data());
}

void look_around_part(csim &sim, const Step &step, Range range) {
    for (std::size_t i = range.begin; i < std::min(range.end, sim.world.copters.size()); ++i)
        if (!sim.is_private(i))
            look_around(sim, step, i);
}

bool counts_down(std::uint64_t *count, std::uint64_t divisor) {
    if (++*count < divisor)
        return false;
    *count = 0;
    return true;
}

Step start_step(World &world, const StepPlan &plan) {
    Step step{world.time_us + plan.dt_us, false, false, 0};
    step.broadcast = counts_down(&world.its_count, plan.its_div);
    step.anchors =
        counts_down(&world.anchor_count, plan.anchor_div) && !world.ranging.anchors().empty();
    if (step.anchors)
        step.anchor = world.ranging.advance();
    return step;
}

void note_active_probes(csim &sim) {
    World &world = sim.world;
    if (!sim.probes.refresh(sim.faults, world.copters, world.ranging, sim.renewed))
        return;
    std::fill(sim.has_ranges.begin(), sim.has_ranges.end(), std::uint8_t{0});
    for (const ActiveProbe &probe : sim.probes.of_ranges())
        sim.has_ranges[probe.copter] = 1;
    for (PrivateMap &map : world.broadcasts.privates)
        map.armed = false;
    for (const std::size_t i : sim.probes.channels()) {
        const std::int32_t id = world.copters.id[i];
        world.broadcasts.make_private(id, world.copters.born[i], channel_name(id)).armed = true;
    }
    sim.note_privates();
}

// Grids for the shared table, which lists are then made from as copters need them.
void prepare_lists(csim &sim, const StepPlan &plan, const Step &step) {
    if (sim.brute_force)
        return;
    if (step.broadcast)
        std::swap(sim.risk, sim.risk_before);
    else if (sim.risk.covers(step.end))
        return;
    const std::uint64_t period = plan.dt_us * std::min<std::uint64_t>(plan.its_div, kLongestLists);
    const std::uint64_t hold = std::max(plan.dt_us, std::min(period, kLongestLists));
    sim.risk.build(sim.world.params, sim.world.broadcasts.now, step.end, step.end + hold);
}

void check_contacts(csim &sim, std::uint64_t end) {
    World &world = sim.world;
    if (!sim.brute_force)
        sim.contacts.refresh(world.params, world.terrain, world.copters);
    const bool found = world.collisions.check(world.params, world.terrain, world.copters,
                                              sim.brute_force ? nullptr : &sim.contacts, end);
    if (found && world.params.halt_on_collision != 0)
        world.status = CSIM_COLLIDED;
    if (world.closeness.watching())
        world.closeness.look(world.params, world.terrain, world.copters, end);
}

} // namespace

StepPlan make_plan(const Params &params, std::uint64_t dt_us, int its_div, int anchor_div) {
    const double dt = static_cast<double>(dt_us) * 1e-6;
    return {dt_us,
            dt,
            static_cast<std::uint64_t>(std::max(its_div, 1)),
            static_cast<std::uint64_t>(std::max(anchor_div, 1)),
            make_motion(params, dt),
            make_response(dt)};
}

void move_all(csim &sim, const StepPlan &plan) {
    in_parts(sim, [&](Range range) { move_part(sim, plan, range); });
}

void run_step(csim &sim, const StepPlan &plan) {
    note_active_probes(sim);
    sim.renewed = false;
    World &world = sim.world;
    const Step step = start_step(world, plan);
    move_all(sim, plan);
    probe_copters(sim, step.end);
    if (step.broadcast)
        fill_broadcast(sim, plan, step);
    world.broadcasts.expire(step.end, world.params.expiry(), step.broadcast);
    prepare_lists(sim, plan, step);
    if (world.broadcasts.privates.empty()) {
        in_parts(sim, [&](Range range) {
            look_around_part(sim, step, range);
            finish_part(sim, plan, step, range);
        });
    } else {
        in_parts(sim, [&](Range range) { look_around_part(sim, step, range); });
        look_around_privately(sim, plan, step);
        in_parts(sim, [&](Range range) { finish_part(sim, plan, step, range); });
    }
    check_contacts(sim, step.end);
    world.time_us = step.end;
}

} // namespace coptersim
