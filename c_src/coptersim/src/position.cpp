#include "position.h"

#include <algorithm>
#include <cmath>

namespace coptersim {

namespace {

// v' = a - k v in closed form; with k -> 0 the limit.
Motion exact_motion(double drag, double dt) {
    if (drag == 1)
        return {dt, 0.5 * dt * dt, 1, dt};
    const double k = -csim_kernels::log(drag);
    const double left = csim_kernels::pow(drag, dt);
    const double way = (1 - left) / k;
    return {way, (dt - way) / k, left, way};
}

double towards_zero(double v, double amount) {
    return v > amount ? v - amount : v < -amount ? v + amount : 0.0;
}

} // namespace

// "v1" starts from the velocity already advanced and adds 5/6 of the increment once more.
Motion make_motion(const Params &params, double dt) {
    const double left = csim_kernels::pow(params.drag, dt);
    switch (static_cast<int>(params.integrator)) {
    case kExact:
        return exact_motion(params.drag, dt);
    case kEuler:
        return {dt, 0, left, left * dt};
    default:
        return {dt, dt * dt * (11.0 / 6), left, left * dt};
    }
}

void limit_velocity(const Params &params, double dt, double roll, double pitch, double *vx,
                    double *vy) {
    if (params.tilt_cutoff < 180 &&
        (std::fabs(roll) > params.tilt_cutoff || std::fabs(pitch) > params.tilt_cutoff)) {
        *vx = *vy = 0;
        return;
    }
    *vx = towards_zero(*vx, params.drag_linear * dt);
    *vy = towards_zero(*vy, params.drag_linear * dt);
    const double speed = std::sqrt(*vx * *vx + *vy * *vy);
    if (params.max_speed > 0 && speed > params.max_speed) {
        *vx *= params.max_speed / speed;
        *vy *= params.max_speed / speed;
    }
}

} // namespace coptersim
