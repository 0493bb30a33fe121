// Risk ellipses, their overlap with the own comfort zone, and the push that follows.
#pragma once

#include "message.h"
#include "params.h"
#include "terrain.h"

namespace coptersim {

// The receiver, as it perceives itself.
struct Own {
    double x, y, vx, vy;
    double comfort; // m, radius
};

struct Other {
    double x, y, vx, vy;
    double age; // s, of the message
};

// Semi-axes along and across the unit vector (ex, ey).
struct Ellipse {
    double cx, cy, ex, ey, along, across;
};

Ellipse copter_ellipse(const Params &params, const Own &own, const Other &other);
Ellipse line_ellipse(const Params &params, const Own &own, const Line &line);

// Below 1 when the ellipse and the comfort zone overlap.
double overlap_of(const Ellipse &ellipse, const Own &own);

// The sum of what all overlapping ellipses add.
struct Push {
    double x = 0, y = 0;
    bool any = false;
};
void add_copter(const Params &params, const Own &own, const Other &other, Push *push);
void add_line(const Params &params, const Own &own, const Line &line, Push *push);

// Towards where the copter flies, so that the command that follows brakes.
void add_stop(const Own &own, Push *push);

// The command that follows a push, in -1..1; 0 when it is not finite.
struct Override {
    double roll, pitch;
};
Override command_of(const Params &params, const Push &push, double yaw);

// A copter farther away than this cannot overlap, at relative speeds up to `speed`.
double copter_reach(const Params &params, double comfort, double speed);
// A line whose box (Terrain::prepare) is farther away in x or y cannot, at speeds up to `speed`.
double line_reach(const Params &params, double comfort, double speed);
// The same for Own::comfort: its largest value.
double largest_comfort(const Params &params, const csim_gains &gains);

} // namespace coptersim
