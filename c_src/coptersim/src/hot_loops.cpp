// Compiled once for each vector width: CSIM_BUILD names the build, CSIM_WIDTH is the number of
// doubles in its vectors. Everything has internal linkage but the table, so that no build can end
// up running another's instructions.
#include "hot_loops.h"

#include "attitude.h"
#include "kernels.h"
#include "position.h"

#include <cstring>

#define CSIM_TEXT_(name) #name
#define CSIM_TEXT(name) CSIM_TEXT_(name)
#define CSIM_JOIN_(a, b) a##b
#define CSIM_JOIN(a, b) CSIM_JOIN_(a, b)

namespace coptersim {

namespace {

typedef double Real __attribute__((vector_size(CSIM_WIDTH * sizeof(double))));
using Mask = csim_kernels::bits_t<Real>;

inline Real load(const double *from) {
    Real value;
    std::memcpy(&value, from, sizeof value);
    return value;
}
inline void store(double *to, Real value) {
    std::memcpy(to, &value, sizeof value);
}

bool any(Mask mask) {
    std::int64_t all = 0;
    for (std::size_t lane = 0; lane < CSIM_WIDTH; ++lane)
        all |= mask[lane];
    return all != 0;
}

void accelerate(std::size_t begin, std::size_t end, const Attitude &in, double *ax, double *ay) {
    for (std::size_t i = begin; i < end; i += CSIM_WIDTH) {
        const Acceleration<Real> a =
            acceleration(load(in.roll + i) + load(in.e_r + i),
                         load(in.pitch + i) + load(in.e_p + i), load(in.yaw + i));
        store(ax + i, a.x);
        store(ay + i, a.y);
    }
}

void move(std::size_t begin, std::size_t end, const Motion &motion, double *p, double *v,
          const double *a) {
    for (std::size_t i = begin; i < end; i += CSIM_WIDTH) {
        const Real speed = load(v + i), push = load(a + i);
        store(p + i, load(p + i) + (motion.p_v * speed + motion.p_a * push));
        store(v + i, motion.v_v * speed + motion.v_a * push);
    }
}

bool respond(std::size_t begin, std::size_t end, const Response &response, const Commands &commands,
             double *roll, double *pitch, double *yaw) {
    Mask far{};
    for (std::size_t i = begin; i < end; i += CSIM_WIDTH) {
        const Real r = tilt_after(load(roll + i), load(commands.roll + i), response);
        const Real p = tilt_after(load(pitch + i), load(commands.pitch + i), response);
        const Real y = load(yaw + i) + response.turn * load(commands.yaw + i);
        far |= is_far(r) | is_far(p) | is_far(y);
        store(roll + i, wrap_near(r));
        store(pitch + i, wrap_near(p));
        store(yaw + i, wrap_near(y));
    }
    return any(far);
}

void track(std::size_t begin, std::size_t end, const double *x, const double *y, const double *u,
           const double *v, double *max2) {
    for (std::size_t i = begin; i < end; i += CSIM_WIDTH) {
        const Real dx = load(x + i) - load(u + i), dy = load(y + i) - load(v + i);
        const Real d2 = dx * dx + dy * dy, most = load(max2 + i);
        store(max2 + i, d2 > most ? d2 : most);
    }
}

} // namespace

extern const HotLoops CSIM_JOIN(hot_loops_, CSIM_BUILD);
const HotLoops CSIM_JOIN(hot_loops_, CSIM_BUILD) = {CSIM_TEXT(CSIM_BUILD), accelerate, move,
                                                    respond, track};

} // namespace coptersim
