// Lines, anchors and copters of csim.h.
#include "api.h"
#include "attitude.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace coptersim;

namespace {

int check_id(const char *function, std::int32_t id) {
    return id >= 0 ? CSIM_OK : fail(CSIM_E_ARG, "%s: id %d is negative", function, id);
}

int check_coordinates(const char *function, std::initializer_list<double> values) {
    for (const double value : values)
        if (!is_coordinate(value))
            return fail(CSIM_E_ARG, "%s: coordinate %g is not within +-%g m", function, value,
                        kFarthest);
    return CSIM_OK;
}

int check_thing(const csim *sim, const char *function, std::int32_t id,
                std::initializer_list<double> values) {
    if (sim == nullptr)
        return fail_null(function, "sim");
    const int code = check_id(function, id);
    return code != CSIM_OK ? code : check_coordinates(function, values);
}

// Its place in the columns; a copter of that id is forgotten.
std::size_t make_room(World &world, std::int32_t id) {
    const std::ptrdiff_t known = world.copters.find(id);
    if (known >= 0) {
        const auto at = static_cast<std::size_t>(known);
        world.copters.erase(at);
        world.ranging.erase_copter(at);
    }
    const std::size_t at = world.copters.lower(id);
    world.ranging.insert_copter(at);
    world.copters.insert(at, id);
    return at;
}

void forget_messages(csim *sim, std::int32_t id) {
    if (const PrivateMap *map = sim->world.broadcasts.find_private(id)) {
        fc_channel_clear(sim->faults, map->channel.c_str());
        sim->world.broadcasts.end_private(id);
    }
}

bool is_valid(const csim_state &s) {
    return is_coordinate(s.px) && is_coordinate(s.py) && is_coordinate(s.pz) &&
           std::isfinite(s.vx) && std::isfinite(s.vy) && std::isfinite(s.roll) &&
           std::isfinite(s.pitch) && std::isfinite(s.yaw) && std::isfinite(s.e_r) &&
           std::isfinite(s.e_p);
}

} // namespace

extern "C" {

int csim_add_line(csim *sim, int32_t id, double x1, double y1, double x2, double y2) {
    if (const int code = check_thing(sim, "csim_add_line", id, {x1, y1, x2, y2}))
        return code;
    return guarded("csim_add_line", [&] {
        sim->world.terrain.add(make_line(id, x1, y1, x2, y2));
        sim->world.collisions.forget_line(id);
        sim->renewed = true;
        return CSIM_OK;
    });
}

int csim_clear_lines(csim *sim) {
    if (sim == nullptr)
        return fail_null("csim_clear_lines", "sim");
    sim->world.terrain.clear();
    sim->renewed = true;
    return CSIM_OK;
}

int csim_add_anchor(csim *sim, int32_t id, double x, double y, double z) {
    if (const int code = check_thing(sim, "csim_add_anchor", id, {x, y, z}))
        return code;
    return guarded("csim_add_anchor", [&] {
        sim->world.ranging.add_anchor({id, x, y, z}, sim->world.copters.size());
        sim->renewed = true;
        return CSIM_OK;
    });
}

int csim_clear_anchors(csim *sim) {
    if (sim == nullptr)
        return fail_null("csim_clear_anchors", "sim");
    sim->world.ranging.clear_anchors();
    sim->renewed = true;
    return CSIM_OK;
}

int csim_add_copter(csim *sim, int32_t id, double px, double py, double yaw) {
    int code = check_thing(sim, "csim_add_copter", id, {px, py});
    if (code == CSIM_OK && !std::isfinite(yaw))
        code = fail(CSIM_E_ARG, "csim_add_copter: yaw %g is not finite", yaw);
    if (code != CSIM_OK)
        return code;
    return guarded("csim_add_copter", [&] {
        World &world = sim->world;
        const std::size_t i = make_room(world, id);
        // + 0.0 makes -0 a 0, which corrections by nothing would not keep.
        const csim_state state{px + 0.0, py + 0.0, world.params.altitude, 0, 0,
                               0,        0,        wrap(yaw) + 0.0,       0, 0};
        world.copters.truth.set(i, state);
        world.copters.belief.set(i, state);
        world.copters.gains[i] = world.params.gains;
        world.copters.born[i] = world.broadcasts.count;
        forget_messages(sim, id);
        world.collisions.forget_copter(id);
        // What a newcomer finds plausible may differ from what the others do.
        if (world.params.plausibility != 0)
            world.broadcasts.make_private(id, world.broadcasts.count, channel_name(id));
        sim->renewed = true;
        return CSIM_OK;
    });
}

int csim_remove_copter(csim *sim, int32_t id) {
    std::size_t i = 0;
    if (const int code = find_copter(sim, id, "csim_remove_copter", &i))
        return code;
    sim->world.copters.erase(i);
    sim->world.ranging.erase_copter(i);
    forget_messages(sim, id);
    sim->world.collisions.forget_copter(id);
    sim->renewed = true;
    return CSIM_OK;
}

int csim_clear_copters(csim *sim) {
    if (sim == nullptr)
        return fail_null("csim_clear_copters", "sim");
    while (sim->world.copters.size() > 0)
        csim_remove_copter(sim, sim->world.copters.id.back());
    return CSIM_OK;
}

int csim_count(const csim *sim) {
    return sim != nullptr ? static_cast<int>(sim->world.copters.size())
                          : fail_null("csim_count", "sim");
}

int csim_command(csim *sim, int32_t copter, double roll, double pitch, double yaw,
                 double throttle) {
    std::size_t i = 0;
    if (const int code = find_copter(sim, copter, "csim_command", &i))
        return code;
    if (std::isnan(roll) || std::isnan(pitch) || std::isnan(yaw) || std::isnan(throttle))
        return fail(CSIM_E_ARG, "csim_command: a command of copter %d is NaN", copter);
    Columns &c = sim->world.copters;
    c.pilot_roll[i] = std::clamp(roll, -1.0, 1.0);
    c.pilot_pitch[i] = std::clamp(pitch, -1.0, 1.0);
    c.pilot_yaw[i] = std::clamp(yaw, -1.0, 1.0);
    c.throttle[i] = std::clamp(throttle, 0.0, 1.0);
    if (!c.override_active[i]) {
        c.roll[i] = c.pilot_roll[i];
        c.pitch[i] = c.pilot_pitch[i];
        c.yaw[i] = c.pilot_yaw[i];
    }
    return CSIM_OK;
}

int csim_get_state(const csim *sim, int32_t copter, csim_view view, csim_state *state) {
    std::size_t i = 0;
    if (const int code = find_copter(sim, copter, "csim_get_state", &i))
        return code;
    if (state == nullptr)
        return fail_null("csim_get_state", "state");
    const Columns &c = sim->world.copters;
    *state = (view == CSIM_TRUE ? c.truth : c.belief).at(i);
    return CSIM_OK;
}

int csim_set_state(csim *sim, int32_t copter, csim_view view, const csim_state *state) {
    std::size_t i = 0;
    if (const int code = find_copter(sim, copter, "csim_set_state", &i))
        return code;
    if (state == nullptr)
        return fail_null("csim_set_state", "state");
    if (!is_valid(*state))
        return fail(CSIM_E_ARG,
                    "csim_set_state: copter %d: a value is not finite, or a "
                    "coordinate not within +-%g m",
                    copter, kFarthest);
    csim_state wrapped = *state;
    wrapped.roll = wrap(state->roll);
    wrapped.pitch = wrap(state->pitch);
    wrapped.yaw = wrap(state->yaw);
    if (view == CSIM_TRUE)
        wrapped.e_r = wrapped.e_p = 0;
    Columns &c = sim->world.copters;
    (view == CSIM_TRUE ? c.truth : c.belief).set(i, wrapped);
    c.own_attitude[i] = 1;
    sim->lists_stale = true;
    return CSIM_OK;
}

int csim_override(const csim *sim, int32_t copter, csim_station *station) {
    std::size_t i = 0;
    if (const int code = find_copter(sim, copter, "csim_override", &i))
        return code;
    if (station == nullptr)
        return fail_null("csim_override", "station");
    const Columns &c = sim->world.copters;
    const bool active = c.override_active[i] != 0;
    *station = {
        active,        active ? c.roll[i] : 0,    active ? c.pitch[i] : 0, c.override_steps[i],
        c.rejected[i], std::sqrt(c.max_error2[i])};
    return CSIM_OK;
}

int csim_columns(const csim *sim, csim_view view, csim_columns_view *columns) {
    if (sim == nullptr || columns == nullptr)
        return fail_null("csim_columns", sim == nullptr ? "sim" : "columns");
    const Columns &c = sim->world.copters;
    const StateColumns &s = view == CSIM_TRUE ? c.truth : c.belief;
    *columns = {static_cast<int>(c.size()),
                c.id.data(),
                s.px.data(),
                s.py.data(),
                s.pz.data(),
                s.vx.data(),
                s.vy.data(),
                s.roll.data(),
                s.pitch.data(),
                s.yaw.data(),
                s.e_r.data(),
                s.e_p.data(),
                c.override_active.data(),
                c.roll.data(),
                c.pitch.data()};
    return CSIM_OK;
}

int csim_ranges(const csim *sim, int32_t copter, csim_range *list, size_t *count) {
    std::size_t i = 0;
    if (const int code = find_copter(sim, copter, "csim_ranges", &i))
        return code;
    if (count == nullptr)
        return fail_null("csim_ranges", "count");
    return guarded("csim_ranges", [&] {
        const Ranging &ranging = sim->world.ranging;
        std::vector<csim_range> ranges;
        for (std::size_t k = 0; k < ranging.anchors().size(); ++k) {
            const RangeMemory &memory = ranging.memories(i)[k];
            if (memory.measured_at != 0)
                ranges.push_back({ranging.anchors()[k].id, memory.measured, memory.expected,
                                  memory.used, memory.measured_at});
        }
        return copy_out(ranges, list, count, "csim_ranges");
    });
}

} // extern "C"
