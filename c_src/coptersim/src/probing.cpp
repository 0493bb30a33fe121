// Where the probes stand in a step.
#include "attitude.h"
#include "step.h"

#include <algorithm>
#include <cmath>

namespace coptersim {

namespace {

void probe(csim &sim, const ActiveProbe &active, double *value) {
    fc_probe_f64(sim.faults, active.name.c_str(), value);
}

void probe_angle(csim &sim, const ActiveProbe &active, Column *angles) {
    double angle = (*angles)[active.copter];
    probe(sim, active, &angle);
    (*angles)[active.copter] = wrap(angle);
    sim.world.copters.own_attitude[active.copter] = 1;
}

// A position that jumps is not believed when there is a guard.
void probe_position(csim &sim, const ActiveProbe &active, Column *positions) {
    const double guard = sim.world.params.state_guard;
    const double reckoned = (*positions)[active.copter];
    double position = reckoned;
    probe(sim, active, &position);
    if (guard == 0 || std::fabs(position - reckoned) <= guard)
        (*positions)[active.copter] = position;
}

// The active range probes of a copter and anchor.
template <class F>
void each_range_probe(const csim &sim, std::size_t copter, std::size_t anchor, F f) {
    const auto &list = sim.probes.of_ranges();
    auto at = std::lower_bound(list.begin(), list.end(), std::make_pair(copter, anchor),
                               [](const ActiveProbe &probe, const auto &key) {
                                   return std::make_pair(probe.copter, probe.anchor) < key;
                               });
    for (; at != list.end() && at->copter == copter && at->anchor == anchor; ++at)
        f(*at);
}

void probe_range(csim &sim, const ActiveProbe &active, RangeSample *sample) {
    switch (active.kind) {
    case ProbeKind::anchor_x:
        return probe(sim, active, &sample->anchor.x);
    case ProbeKind::anchor_y:
        return probe(sim, active, &sample->anchor.y);
    case ProbeKind::anchor_z:
        return probe(sim, active, &sample->anchor.z);
    default:
        return probe(sim, active, &sample->measured);
    }
}

} // namespace

void probe_copters(csim &sim, std::uint64_t end) {
    StateColumns &belief = sim.world.copters.belief;
    std::fill(sim.stamps.begin(), sim.stamps.end(), end);
    for (const ActiveProbe &active : sim.probes.of_copters()) {
        switch (active.kind) {
        case ProbeKind::pitch:
            probe_angle(sim, active, &belief.pitch);
            break;
        case ProbeKind::roll:
            probe_angle(sim, active, &belief.roll);
            break;
        case ProbeKind::yaw:
            probe_angle(sim, active, &belief.yaw);
            break;
        case ProbeKind::px:
            probe_position(sim, active, &belief.px);
            break;
        case ProbeKind::py:
            probe_position(sim, active, &belief.py);
            break;
        default:
            fc_probe_u64(sim.faults, active.name.c_str(), &sim.stamps[active.copter]);
        }
    }
}

// Section 5: both distances come from one expression.
void range_one(csim &sim, const Step &step, std::size_t i) {
    World &world = sim.world;
    Columns &c = world.copters;
    const double altitude = world.params.altitude;
    const Anchor &anchor = world.ranging.anchors()[step.anchor];
    c.truth.pz[i] = c.belief.pz[i] = altitude;
    RangeSample sample{anchor, distance_to(anchor, c.truth.px[i], c.truth.py[i], altitude),
                       altitude, step.end};
    if (sim.has_ranges[i])
        each_range_probe(sim, i, step.anchor,
                         [&](const ActiveProbe &active) { probe_range(sim, active, &sample); });
    correct(world.params, sample, world.ranging.memories(i), world.ranging.anchors().size(),
            step.anchor, i, &c);
    if (c.belief.e_r[i] != 0 || c.belief.e_p[i] != 0)
        c.own_attitude[i] = 1;
}

} // namespace coptersim
