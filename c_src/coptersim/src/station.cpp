// What each copter makes of its local dynamic map: follow the pilot, or override.
#include "risk.h"
#include "step.h"

#include <cmath>

namespace coptersim {

namespace {

bool is_finite(const Own &own) {
    return std::isfinite(own.x + own.y + own.vx + own.vy);
}

// A copter without a place overlaps nothing.
void follow(Columns &c, std::size_t i, const Params &params, const Push &push) {
    if (!push.any) {
        if (c.override_active[i]) {
            c.override_active[i] = 0;
            c.roll[i] = c.pilot_roll[i];
            c.pitch[i] = c.pilot_pitch[i];
            c.yaw[i] = c.pilot_yaw[i];
        }
        return;
    }
    const Override command = command_of(params, push, c.belief.yaw[i]);
    c.override_active[i] = 1;
    ++c.override_steps[i];
    c.roll[i] = command.roll;
    c.pitch[i] = command.pitch;
    c.yaw[i] = 0;
}

// Adds rows of the shared table to a push.
class SharedMap {
  public:
    SharedMap(const csim &sim, const Own &own, std::uint64_t now, std::size_t i, Push *push)
        : params_(sim.world.params), own_(own), now_(now), id_(sim.world.copters.id[i]),
          born_(sim.world.copters.born[i]), push_(push) {}

    void add(const TableRow &row) const {
        if (!knows(row, id_, born_))
            return;
        const Position place = extrapolate(row.heard, known_from(row, id_), now_);
        add_copter(params_, own_,
                   {place.x, place.y, row.heard.vx, row.heard.vy, age_of(row.heard.stamp, now_)},
                   push_);
    }
    void add_lower(const TableRow &row) const {
        if (row.id < id_)
            add(row);
    }
    void add_higher(const TableRow &row) const {
        if (row.id > id_)
            add(row);
    }

  private:
    const Params &params_;
    const Own &own_;
    std::uint64_t now_;
    std::int32_t id_;
    std::uint64_t born_;
    Push *push_;
};

// f(row) for all rows that the list of copter i names.
template <class F>
void each_listed(const Lists &lists, std::size_t i, const std::vector<TableRow> &rows, F f) {
    if (lists.is_all(i)) {
        for (const TableRow &row : rows)
            f(row);
    } else {
        for (const std::uint32_t *at = lists.begin(i); at != lists.end(i); ++at)
            f(rows[*at]);
    }
}

// Makes lists that do not hold any more.
void hold(csim &sim, RiskTable *table, const Own &own, std::size_t i) {
    if (!table->held[i].holds(own.x, own.y, own.vx, own.vy))
        table->make_lists(sim.world.params, sim.world.terrain, sim.world.copters, i);
}

// In the step of a broadcast, senders with a larger id have not been heard yet.
void add_shared(csim &sim, const Step &step, const Own &own, std::size_t i, Push *push) {
    const Broadcasts &known = sim.world.broadcasts;
    const SharedMap map(sim, own, step.end, i, push);
    const bool listed = !sim.brute_force;
    if (listed)
        hold(sim, &sim.risk, own, i);
    const auto each = [&](RiskTable &table, const std::vector<TableRow> &rows, auto f) {
        if (listed && table.covers(step.end)) {
            hold(sim, &table, own, i);
            each_listed(table.rows, i, rows, f);
        } else {
            for (const TableRow &row : rows)
                f(row);
        }
    };
    if (!step.broadcast) {
        each(sim.risk, known.now, [&](const TableRow &row) { map.add(row); });
    } else {
        each(sim.risk, known.now, [&](const TableRow &row) { map.add_lower(row); });
        each(sim.risk_before, known.before, [&](const TableRow &row) { map.add_higher(row); });
    }
}

void add_private(const Params &params, const PrivateMap &map, const Own &own, std::uint64_t now,
                 Push *push) {
    for (const PrivateRow &row : map.rows) {
        const Position place = extrapolate(row.heard, row.from, now);
        add_copter(params, own,
                   {place.x, place.y, row.heard.vx, row.heard.vy, age_of(row.heard.stamp, now)},
                   push);
    }
}

void add_lines(const csim &sim, const Own &own, std::size_t i, bool listed, Push *push) {
    const std::vector<Line> &lines = sim.world.terrain.lines();
    if (listed && !sim.risk.lines.is_all(i)) {
        const Lists &lists = sim.risk.lines;
        for (const std::uint32_t *at = lists.begin(i); at != lists.end(i); ++at)
            add_line(sim.world.params, own, lines[*at], push);
    } else {
        for (const Line &line : lines)
            add_line(sim.world.params, own, line, push);
    }
}

// Nobody has been heard for long: it may be deaf.
bool is_silent(const World &world, std::uint64_t heard_at, std::uint64_t now) {
    return world.params.silence_us > 0 && world.broadcasts.last_at > 0 &&
           static_cast<double>(now - heard_at) > world.params.silence_us;
}

} // namespace

Own own_of(const World &world, std::size_t i) {
    const Columns &c = world.copters;
    return {c.belief.px[i], c.belief.py[i], c.belief.vx[i], c.belief.vy[i],
            world.params.comfort_radius + world.params.comfort_error_gain * c.confidence[i]};
}

void look_around(csim &sim, const Step &step, std::size_t i) {
    const Own own = own_of(sim.world, i);
    Push push;
    if (is_finite(own)) {
        if (is_silent(sim.world, sim.world.broadcasts.last_at, step.end))
            add_stop(own, &push);
        add_shared(sim, step, own, i, &push);
        add_lines(sim, own, i, !sim.brute_force, &push);
    }
    follow(sim.world.copters, i, sim.world.params, push);
}

void look_around_in(csim &sim, const PrivateMap &map, std::uint64_t now, std::size_t i) {
    const Own own = own_of(sim.world, i);
    Push push;
    if (is_finite(own)) {
        if (is_silent(sim.world, map.heard_at, now))
            add_stop(own, &push);
        add_private(sim.world.params, map, own, now, &push);
        add_lines(sim, own, i, false, &push);
    }
    follow(sim.world.copters, i, sim.world.params, push);
}

} // namespace coptersim
