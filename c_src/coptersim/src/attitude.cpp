#include "attitude.h"

namespace coptersim {

Response make_response(double dt) {
    return {kTiltRate * dt, kTurnRate * dt, csim_kernels::pow(kTiltKept, 1000 * dt)};
}

} // namespace coptersim
