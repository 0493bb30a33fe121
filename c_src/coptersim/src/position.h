// Dead reckoning: from attitude to acceleration, velocity and position.
#pragma once

#include "hot_loops.h"
#include "kernels.h"
#include "params.h"

namespace coptersim {

constexpr double kGravity = 9.82; // m/s^2

template <class Real> struct Acceleration { Real x, y; };

// World, m/s^2. Positive roll accelerates along the body's +x, positive pitch along its -y.
template <class Real> CSIM_KERNEL Acceleration<Real> acceleration(Real roll, Real pitch, Real yaw) {
    const Real bx = kGravity * csim_kernels::tan(roll);
    const Real by = -kGravity * csim_kernels::tan(pitch);
    const csim_kernels::direction<Real> heading = csim_kernels::sin_cos(yaw);
    return {heading.cosine * bx - heading.sine * by, heading.sine * bx + heading.cosine * by};
}

// Of one step of dt seconds.
Motion make_motion(const Params &params, double dt);

// True when velocities need limit_velocity after the motion.
inline bool limits_velocity(const Params &params) {
    return params.drag_linear > 0 || params.max_speed > 0 || params.tilt_cutoff < 180;
}

// The limits of the flight software on one copter's velocity.
void limit_velocity(const Params &params, double dt, double roll, double pitch, double *vx,
                    double *vy);

} // namespace coptersim
