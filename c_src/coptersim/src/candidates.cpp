#include "candidates.h"

#include "risk.h"

#include <algorithm>
#include <cmath>

namespace coptersim {

namespace {

constexpr std::size_t kRoom = 64;     // of a copter's list; fewer copters than that always fit
constexpr std::size_t kLineRoom = 12; // lines
constexpr double kMargin = 0.25;      // m, that a copter may move anyway
constexpr double kSpeedMargin = 0.6;  // m/s
constexpr double kContactTime = 0.2;  // s, that contact lists are to hold
constexpr double kLargestMargin = 4;  // m; a copter that needs more is loose

double speed_of(double vx, double vy) {
    return std::sqrt(vx * vx + vy * vy);
}

} // namespace

void Lists::sort(std::size_t copter) {
    if (!is_all(copter))
        std::sort(items_.begin() + static_cast<std::ptrdiff_t>(copter * room_),
                  items_.begin() + static_cast<std::ptrdiff_t>(copter * room_ + count_[copter]));
}

// ---- Risk ----

void RiskTable::resize(std::size_t copters, std::size_t row_count, std::size_t line_count) {
    rows.resize(copters, std::min(row_count, kRoom));
    lines.resize(copters, std::min(line_count, kLineRoom));
    held.assign(copters, Held());
    for (HashGrid &grid : grids_)
        grid.reserve(row_count);
    loose_.reserve(row_count);
    x_.assign(row_count, 0);
    y_.assign(row_count, 0);
    speed_.assign(row_count, 0);
    built_ = false;
}

void RiskTable::drop_lists() {
    std::fill(held.begin(), held.end(), Held());
    built_ = false;
}

int RiskTable::class_of(double speed) {
    int k = 0;
    for (double limit = 1; k < kClasses && !(speed <= limit); limit *= 2)
        ++k;
    return k;
}

void RiskTable::build(const Params &params, const std::vector<TableRow> &table, std::uint64_t now,
                      std::uint64_t until) {
    horizon_ = static_cast<double>(until - now) * 1e-6;
    until_ = until;
    built_ = true;
    loose_.clear();
    longest_step_ = 0;
    for (int k = 0; k < kClasses; ++k)
        grids_[static_cast<std::size_t>(k)].clear(
            copter_reach(params, params.comfort_radius, std::ldexp(1.0, k)) + kMargin);
    for (std::size_t i = 0; i < table.size(); ++i) {
        const TableRow &row = table[i];
        if (!row.valid)
            continue;
        const Position place = extrapolate(row.heard, row.at, now);
        x_[i] = place.x;
        y_[i] = place.y;
        speed_[i] = speed_of(row.heard.vx, row.heard.vy);
        longest_step_ = std::max(longest_step_, static_cast<double>(row.lasted) * 1e-6);
        if (!std::isfinite(x_[i] + y_[i] + speed_[i]))
            continue; // overlaps nothing
        const int k = class_of(speed_[i]);
        if (k < kClasses && fits_grid(place.x, place.y))
            grids_[static_cast<std::size_t>(k)].add(place.x, place.y,
                                                    static_cast<std::uint32_t>(i));
        else
            loose_.push_back(static_cast<std::uint32_t>(i));
    }
    for (HashGrid &grid : grids_)
        grid.build();
    std::fill(held.begin(), held.end(), Held());
}

void RiskTable::make_lists(const Params &params, const Terrain &terrain, const Columns &copters,
                           std::size_t i) {
    const StateColumns &belief = copters.belief;
    const double x = belief.px[i], y = belief.py[i];
    const double speed = speed_of(belief.vx[i], belief.vy[i]);
    const double fastest = speed + kSpeedMargin, margin = kMargin + speed * horizon_;
    const double comfort = largest_comfort(params, copters.gains[i]);
    rows.start(i);
    lines.start(i);
    for (const std::uint32_t row : loose_)
        rows.add(i, row);
    for (int k = 0; k < kClasses; ++k) {
        const HashGrid &grid = grids_[static_cast<std::size_t>(k)];
        if (grid.size() == 0)
            continue;
        // Receivers with a larger id have moved the sender on by one step more.
        const auto need = [&](double other) {
            return copter_reach(params, comfort, fastest + other) + margin +
                   other * (horizon_ + longest_step_) + 1e-6;
        };
        grid.near(x, y, need(std::ldexp(1.0, k)), [&](std::uint32_t row) {
            const double dx = x_[row] - x, dy = y_[row] - y, reach = need(speed_[row]);
            if (!(dx * dx + dy * dy > reach * reach))
                rows.add(i, row);
        });
    }
    rows.sort(i);
    terrain.near(x, y, line_reach(params, comfort, fastest) + margin + 1e-6,
                 [&](std::uint32_t line) { lines.add(i, line); });
    lines.sort(i);
    held[i] = {x, y, margin * margin, fastest * fastest};
}

// ---- Contacts ----

void ContactTable::resize(std::size_t count) {
    copters.resize(count, std::min(count, kRoom));
    lines.resize(count, kLineRoom);
    held_.assign(count, Held());
    loose_.assign(count, 0);
    grid_.reserve(count);
    built_ = false;
}

double ContactTable::margin_of(const Columns &c, std::size_t i) const {
    return kMargin + kContactTime * speed_of(c.truth.vx[i], c.truth.vy[i]);
}

void ContactTable::refresh(const Params &params, const Terrain &terrain, const Columns &c) {
    if (!built_ || loose_count_ > 4 + c.size() / 16) {
        build(params, terrain, c);
        return;
    }
    for (std::size_t i = 0; i < c.size(); ++i)
        if (!held_[i].holds(c.truth.px[i], c.truth.py[i], 0, 0) && !loose_[i]) {
            loose_[i] = 1;
            ++loose_count_;
            lines.set_all(i);
        }
}

void ContactTable::build(const Params &params, const Terrain &terrain, const Columns &c) {
    built_ = true;
    loose_count_ = 0;
    double largest = 0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const double margin = margin_of(c, i);
        loose_[i] = !(margin <= kLargestMargin) || !fits_grid(c.truth.px[i], c.truth.py[i]);
        held_[i] = {c.truth.px[i], c.truth.py[i], margin * margin, 0};
        if (!loose_[i])
            largest = std::max(largest, margin);
    }
    grid_.clear(2 * (params.copter_radius + largest) + 1e-3);
    for (std::size_t i = 0; i < c.size(); ++i)
        if (!loose_[i])
            grid_.add(c.truth.px[i], c.truth.py[i], static_cast<std::uint32_t>(i));
    grid_.build();
    for (std::size_t i = 0; i < c.size(); ++i)
        make_lists(params, terrain, c, i, largest);
}

// Pairs of two that are not loose, in the list of the first.
void ContactTable::make_lists(const Params &params, const Terrain &terrain, const Columns &c,
                              std::size_t i, double largest) {
    copters.start(i);
    lines.start(i);
    if (loose_[i]) {
        lines.set_all(i);
        return;
    }
    const double x = c.truth.px[i], y = c.truth.py[i];
    const double margin = std::sqrt(held_[i].margin2);
    grid_.near(x, y, 2 * params.copter_radius + margin + largest, [&](std::uint32_t j) {
        if (j <= i)
            return;
        const double dx = c.truth.px[j] - x, dy = c.truth.py[j] - y;
        const double reach = 2 * params.copter_radius + margin + std::sqrt(held_[j].margin2) + 1e-6;
        if (dx * dx + dy * dy <= reach * reach)
            copters.add(i, j);
    });
    const double reach = params.copter_radius + margin + 1e-6;
    terrain.near(x, y, reach, [&](std::uint32_t index) {
        const Place near = closest_point(terrain.lines()[index], x, y);
        const double dx = near.x - x, dy = near.y - y;
        if (dx * dx + dy * dy <= reach * reach)
            lines.add(i, index);
    });
}

} // namespace coptersim
