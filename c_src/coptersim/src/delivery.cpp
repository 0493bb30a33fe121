// Messages: from the beliefs into the shared table, and through faulted channels to receivers with
// rows of their own.
#include "step.h"

#include <algorithm>
#include <cmath>

namespace coptersim {

namespace {

constexpr int kMostGets = 64; // of one channel at a time, besides those of queued packets
constexpr std::uint64_t kPlausibleAge = 500000; // us

Heard heard_of(const StateColumns &belief, std::size_t i, std::uint64_t stamp) {
    return {belief.px[i], belief.py[i], belief.vx[i], belief.vy[i], stamp};
}

// A packet that a receiver got; `from` as in PrivateRow.
void receive(const csim &sim, const std::uint8_t *bytes, std::size_t size, std::uint64_t now,
             std::uint64_t from, PrivateMap *map) {
    const Params &params = sim.world.params;
    const auto protect = static_cast<Protect>(params.protect);
    if (size != packet_size(protect))
        return;
    const csim_message message = unpack(bytes);
    if (message.id == map->receiver)
        return;
    PrivateRow *known = map->find(message.id);
    LinkState link = known != nullptr ? known->link : LinkState();
    const bool accepted = accept_packet(protect, bytes, &link);
    if (known != nullptr)
        known->link = link;
    const csim_state &state = message.state;
    const Heard heard{state.px, state.py, state.vx, state.vy, message.stamp_us};
    if (!accepted || (params.plausibility != 0 &&
                      !is_plausible(params, heard, now, known != nullptr ? &known->heard : nullptr,
                                    known != nullptr ? known->at : 0)))
        return;
    PrivateRow &row = map->row(message.id);
    row.heard = heard;
    row.from = from;
    row.at = now;
    row.link = link;
    map->heard_at = now;
}

std::int64_t depth_of(const csim &sim, const PrivateMap &map) {
    return std::max<std::int64_t>(0, fc_channel_depth(sim.faults, map.channel.c_str(), ""));
}

// Takes packets until there is none. Faults can make a channel endless, hence the limit.
void take_all(csim &sim, std::uint64_t now, std::uint64_t from, PrivateMap *map) {
    for (std::int64_t left = kMostGets + depth_of(sim, *map); left > 0; --left) {
        std::size_t size = 0;
        const int got = fc_channel_get(sim.faults, map->channel.c_str(), "", sim.packet.data(),
                                       sim.packet.size(), &size);
        if (got == FC_E_SPACE)
            sim.packet.resize(size);
        else if (got == 1)
            receive(sim, sim.packet.data(), size, now, from, map);
        else
            return;
    }
}

void deliver(csim &sim, const std::uint8_t *bytes, std::size_t size, std::uint64_t now,
             std::uint64_t from, PrivateMap *map) {
    if (!map->armed && depth_of(sim, *map) == 0) {
        receive(sim, bytes, size, now, from, map);
        return;
    }
    fc_channel_put(sim.faults, map->channel.c_str(), bytes, size);
    take_all(sim, now, from, map);
}

// To all receivers with rows of their own.
void send(csim &sim, const StepPlan &plan, const Step &step, std::size_t i) {
    const std::int32_t id = sim.world.copters.id[i];
    const auto protect = static_cast<Protect>(sim.world.params.protect);
    std::uint8_t bytes[kLongestPacket];
    pack({id, sim.stamps[i], sim.world.copters.belief.at(i)}, bytes);
    protect_packet(protect, id, sim.world.broadcasts.count, bytes);
    for (PrivateMap &map : sim.world.broadcasts.privates)
        if (map.receiver != id)
            deliver(sim, bytes, packet_size(protect), step.end,
                    step.end - (id < map.receiver ? plan.dt_us : 0), &map);
}

// Receivers whose rows are again those of everybody.
void end_privates(csim &sim) {
    Broadcasts &broadcasts = sim.world.broadcasts;
    for (std::size_t k = broadcasts.privates.size(); k-- > 0;) {
        const PrivateMap &map = broadcasts.privates[k];
        const std::ptrdiff_t i = sim.world.copters.find(map.receiver);
        if (!map.armed && depth_of(sim, map) == 0 &&
            broadcasts.agrees_with_table(map, sim.world.copters.born[static_cast<std::size_t>(i)]))
            broadcasts.end_private(map.receiver);
    }
    sim.note_privates();
}

} // namespace

bool is_plausible(const Params &params, const Heard &heard, std::uint64_t now, const Heard *known,
                  std::uint64_t known_at) {
    const double speed = std::sqrt(heard.vx * heard.vx + heard.vy * heard.vy);
    if (!std::isfinite(heard.px + heard.py) || !(speed <= params.plausible_speed) ||
        heard.stamp > now || now - heard.stamp > kPlausibleAge)
        return false;
    if (known == nullptr)
        return true;
    const Position expected = extrapolate(*known, known_at, now);
    const double dx = heard.px - expected.x, dy = heard.py - expected.y;
    return std::sqrt(dx * dx + dy * dy) <= params.plausible_jump;
}

void fill_broadcast(csim &sim, const StepPlan &plan, const Step &step) {
    World &world = sim.world;
    Broadcasts &broadcasts = world.broadcasts;
    broadcasts.start_broadcast();
    if (world.copters.size() > 1)
        broadcasts.last_at = step.end;
    for (std::size_t i = 0; i < world.copters.size(); ++i) {
        TableRow &row = broadcasts.now[broadcasts.row_of(i)];
        const Heard heard = heard_of(world.copters.belief, i, sim.stamps[i]);
        const bool known = row.valid && !(row.gone_low && row.gone_high);
        if (world.params.plausibility != 0 &&
            !is_plausible(world.params, heard, step.end, known ? &row.heard : nullptr, row.at))
            continue;
        row = {row.id, true, false, false, heard, step.end, plan.dt_us, broadcasts.count};
    }
}

// In the order of a step: each copter polls, looks around, and sends.
void look_around_privately(csim &sim, const StepPlan &plan, const Step &step) {
    World &world = sim.world;
    for (std::size_t i = 0; i < world.copters.size(); ++i) {
        if (sim.is_private(i)) {
            PrivateMap &map = *world.broadcasts.find_private(world.copters.id[i]);
            if (depth_of(sim, map) > 0)
                take_all(sim, step.end, step.end - plan.dt_us, &map);
            map.expire(step.end, world.params.expiry());
            look_around_in(sim, map, step.end, i);
        }
        if (step.broadcast)
            send(sim, plan, step, i);
    }
    if (step.broadcast)
        end_privates(sim);
}

} // namespace coptersim
