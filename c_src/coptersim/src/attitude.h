// How roll, pitch and yaw follow commands, and angles in (-180, 180].
#pragma once

#include "hot_loops.h"
#include "kernels.h"

#include <cmath>

namespace coptersim {

constexpr double kTiltRate = 250; // degrees/s for a full command
constexpr double kTurnRate = 150;
constexpr double kTiltKept = 0.995; // in a millisecond

Response make_response(double dt);

// The leak acts twice: on the new angle, and once more on the old one.
template <class Real>
CSIM_KERNEL Real tilt_after(Real angle, Real command, const Response &response) {
    return (angle + response.tilt * command) * response.keep - angle * (1 - response.keep);
}

// An angle that one turn back or forth does not bring home. All bits set, or none.
template <class Real> CSIM_KERNEL auto is_far(Real angle) {
    return ~(csim_kernels::magnitude(angle) < 540.0);
}

// Into (-180, 180], for angles that are not far. Those that are there keep their bits.
template <class Real> CSIM_KERNEL Real wrap_near(Real angle) {
    const Real down = angle > 180.0 ? angle - 360.0 : angle;
    return down <= -180.0 ? down + 360.0 : down;
}

// Into (-180, 180]; NaN for what is not finite.
inline double wrap(double angle) {
    if (std::fabs(angle) < 540)
        return wrap_near(angle);
    const double turned = std::remainder(angle, 360.0); // exact
    return turned == -180 ? 180 : turned;
}

} // namespace coptersim
