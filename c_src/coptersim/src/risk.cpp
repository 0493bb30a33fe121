#include "risk.h"

#include "kernels.h"

#include <algorithm>
#include <cmath>

namespace coptersim {

namespace {

double length_of(double x, double y) {
    return std::sqrt(x * x + y * y);
}

// m, from the speed (m/s) at which the own copter comes closer to (x, y).
double braking_room(const Params &params, const Own &own, double x, double y, double vx,
                    double vy) {
    if (params.brake_gain == 0)
        return 0;
    const double dx = x - own.x, dy = y - own.y, distance = length_of(dx, dy);
    const double closing = ((own.vx - vx) * dx + (own.vy - vy) * dy) / distance;
    return closing > 0 ? params.brake_gain * closing * closing / (2 * params.brake_accel) : 0;
}

void add(double x, double y, const Own &own, double weight, Push *push) {
    const double dx = x - own.x, dy = y - own.y, distance = length_of(dx, dy);
    push->x += weight * (dx / distance);
    push->y += weight * (dy / distance);
    push->any = true;
}

} // namespace

Ellipse copter_ellipse(const Params &params, const Own &own, const Other &other) {
    const double wx = other.vx - own.vx, wy = other.vy - own.vy, speed = length_of(wx, wy);
    const double ex = speed > 0 ? wx / speed : 1, ey = speed > 0 ? wy / speed : 0;
    const double growth = params.speed_factor * speed * speed;
    const double base = params.base_radius + params.risk_age_gain * other.age +
                        braking_room(params, own, other.x, other.y, other.vx, other.vy);
    return {other.x + params.speed_factor * speed * wx,
            other.y + params.speed_factor * speed * wy,
            ex,
            ey,
            base + growth,
            base + params.cross_factor * growth};
}

Ellipse line_ellipse(const Params &params, const Own &own, const Line &line) {
    const double speed = length_of(own.vx, own.vy);
    const double growth = params.speed_factor * speed * speed;
    double base = params.base_radius;
    if (params.brake_gain > 0) {
        const Place near = closest_point(line, own.x, own.y);
        base += braking_room(params, own, near.x, near.y, 0, 0);
    }
    return {line.mid_x - params.speed_factor * speed * own.vx,
            line.mid_y - params.speed_factor * speed * own.vy,
            line.along_x,
            line.along_y,
            base + line.length / params.length_divisor + growth,
            base + growth};
}

double overlap_of(const Ellipse &ellipse, const Own &own) {
    const double dx = own.x - ellipse.cx, dy = own.y - ellipse.cy;
    const double along = (dx * ellipse.ex + dy * ellipse.ey) / (ellipse.along + own.comfort);
    const double across = (dy * ellipse.ex - dx * ellipse.ey) / (ellipse.across + own.comfort);
    return along * along + across * across;
}

void add_copter(const Params &params, const Own &own, const Other &other, Push *push) {
    const double q = overlap_of(copter_ellipse(params, own, other), own);
    if (q < 1)
        add(other.x, other.y, own, params.copter_weight / q, push);
}

void add_line(const Params &params, const Own &own, const Line &line, Push *push) {
    const double q = overlap_of(line_ellipse(params, own, line), own);
    if (!(q < 1))
        return;
    const Place near = closest_point(line, own.x, own.y);
    add(near.x, near.y, own, params.line_weight, push);
}

void add_stop(const Own &own, Push *push) {
    constexpr double kPerSpeed = 1.5; // s/m
    push->x += kPerSpeed * own.vx;
    push->y += kPerSpeed * own.vy;
    push->any = true;
}

Override command_of(const Params &params, const Push &push, double yaw) {
    double x = params.override_gain * push.x, y = params.override_gain * push.y;
    const double length = length_of(x, y);
    if (!std::isfinite(length))
        return {0, 0};
    if (length > 1) {
        x /= length;
        y /= length;
    }
    const csim_kernels::direction<double> heading = csim_kernels::sin_cos(yaw);
    const double roll = -heading.cosine * x - heading.sine * y;
    const double pitch = -heading.sine * x + heading.cosine * y;
    if (!std::isfinite(roll) || !std::isfinite(pitch))
        return {0, 0};
    return {std::clamp(roll, -1.0, 1.0), std::clamp(pitch, -1.0, 1.0)};
}

double copter_reach(const Params &params, double comfort, double speed) {
    const double growth = params.speed_factor * speed * speed;
    return comfort + params.base_radius + growth + growth * std::max(1.0, params.cross_factor) +
           params.risk_age_gain * params.expiry_us * 1e-6 +
           params.brake_gain * speed * speed / (2 * params.brake_accel);
}

// 1.5 covers the corner of a rectangle that grows by 1 on all sides.
double line_reach(const Params &params, double comfort, double speed) {
    const double growth = params.speed_factor * speed * speed;
    const double brake = params.brake_gain * speed * speed / (2 * params.brake_accel);
    return 1.5 * (comfort + growth + brake) + growth;
}

double largest_comfort(const Params &params, const csim_gains &gains) {
    return params.comfort_radius + params.comfort_error_gain * gains.max_corr;
}

} // namespace coptersim
