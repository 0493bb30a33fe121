#include "closeness.h"

#include <cmath>
#include <limits>

namespace coptersim {

namespace {

constexpr double kBrakingAlone = 4.5; // m/s^2, of one copter at full tilt
constexpr double kBrakingBoth = 9;    // m/s^2, of two
constexpr double kLateCost = 0.3;     // m, at the horizon

} // namespace

void Closeness::watch(csim_closeness_kind kind, std::uint64_t horizon_us) {
    watching_ = true;
    kind_ = kind;
    horizon_us_ = horizon_us;
    closest_ = {std::numeric_limits<double>::infinity(), 0, CSIM_TERRAIN, -1, -1};
}

double Closeness::value_of(double gap, double closing, double braking) const {
    switch (kind_) {
    case CSIM_STOP:
        return closing > 0 ? gap - closing * closing / (2 * braking) : gap;
    case CSIM_LATE:
        return gap + late_;
    default:
        return gap;
    }
}

void Closeness::offer(double value, std::uint64_t now, csim_collision_kind kind, std::int32_t id,
                      std::int32_t other) {
    if (value < closest_.value)
        closest_ = {value, now, kind, id, other};
}

void Closeness::look(const Params &params, const Terrain &terrain, const Columns &copters,
                     std::uint64_t now) {
    const StateColumns &c = copters.truth;
    late_ = kLateCost * static_cast<double>(now) / static_cast<double>(horizon_us_);
    for (std::size_t i = 0; i < copters.size(); ++i) {
        for (const Line &line : terrain.lines()) {
            const Place near = closest_point(line, c.px[i], c.py[i]);
            const double dx = near.x - c.px[i], dy = near.y - c.py[i];
            const double distance = std::sqrt(dx * dx + dy * dy);
            const double closing = (c.vx[i] * dx + c.vy[i] * dy) / distance;
            offer(value_of(distance - params.copter_radius, closing, kBrakingAlone), now,
                  CSIM_TERRAIN, copters.id[i], line.id);
        }
        for (std::size_t j = i + 1; j < copters.size(); ++j) {
            const double dx = c.px[j] - c.px[i], dy = c.py[j] - c.py[i];
            const double distance = std::sqrt(dx * dx + dy * dy);
            const double closing = ((c.vx[i] - c.vx[j]) * dx + (c.vy[i] - c.vy[j]) * dy) / distance;
            offer(value_of(distance - 2 * params.copter_radius, closing, kBrakingBoth), now,
                  CSIM_COPTER, copters.id[i], copters.id[j]);
        }
    }
}

} // namespace coptersim
