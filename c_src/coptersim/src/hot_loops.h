// The loops over all copters, of which a library holds one build for each vector width.
//
// Every build does the same operations on each double and gives the same bits. Ranges begin and end
// at multiples of kLanes.
#pragma once

#include <cstddef>

namespace coptersim {

// One step along an axis: p += p_v v + p_a a, then v = v_v v + v_a a, with the old v in both.
struct Motion {
    double p_v, p_a, v_v, v_a;
};

// What a step makes of commands: degrees for a full command, and the part of an angle that stays.
struct Response {
    double tilt, turn; // degrees
    double keep;       // 0..1
};

// Inputs in degrees.
struct Attitude {
    const double *roll, *pitch, *yaw, *e_r, *e_p;
};

struct Commands {
    const double *roll, *pitch, *yaw; // -1..1
};

struct HotLoops {
    const char *name;
    // Accelerations in the world, m/s^2, from tilt and tilt estimates.
    void (*accelerate)(std::size_t begin, std::size_t end, const Attitude &attitude, double *ax,
                       double *ay);
    void (*move)(std::size_t begin, std::size_t end, const Motion &motion, double *p, double *v,
                 const double *a);
    // Angles are wrapped unless they are beyond +-540 degrees or NaN; true when there is such a
    // one.
    bool (*respond)(std::size_t begin, std::size_t end, const Response &response,
                    const Commands &commands, double *roll, double *pitch, double *yaw);
    // Raises max2 to the square of the distance of (x, y) from (u, v) where that is larger.
    void (*track)(std::size_t begin, std::size_t end, const double *x, const double *y,
                  const double *u, const double *v, double *max2);
};

// Builds that this machine can run, the widest last; nullptr beyond them.
const HotLoops *hot_loops_at(int index);
// The widest, or that of a name; nullptr when this machine cannot run it.
const HotLoops *find_hot_loops(const char *name);

} // namespace coptersim
