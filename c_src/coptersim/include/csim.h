/* csim.h: a simulator of quadcopters that locate themselves by ranging to anchors, tell each other
 * where they are, and steer away from what they would hit (Vedder, Papers II and III).
 *
 * Units: metres, seconds, degrees; simulated time in microseconds. World frame: x right, y up on
 * the map, z height, right-handed. roll, pitch and yaw are in (-180, 180]; yaw is
 * counter-clockwise; positive roll accelerates along the body's +x, positive pitch along its -y.
 *
 * Each copter has a true state and a perceived one, which its estimator keeps from dead reckoning
 * and measured ranges. Faults act on what is perceived, measured and sent, never on the true state.
 *
 * Every simulation stands alone: no globals, no wall clock, no files. The same calls give the same
 * bits, whatever the number of threads, the instruction set and the splitting of runs. One thread
 * at a time may use a simulation. Functions that can fail return CSIM_OK or a negative CSIM_E_ code
 * and then have changed nothing. */
#ifndef CSIM_H
#define CSIM_H

#include "fc.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define CSIM_API __attribute__((visibility("default")))
#else
#define CSIM_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* A simulation. */
typedef struct csim csim;

enum {
    CSIM_OK = 0,
    CSIM_E_ARG = -1,     /* an argument outside the range stated at the function, NaN, NULL */
    CSIM_E_NOMEM = -2,   /* an allocation failed */
    CSIM_E_ID = -3,      /* no copter, line, anchor or LDM entry has this id */
    CSIM_E_NAME = -4,    /* no parameter has this name */
    CSIM_E_SPACE = -5,   /* the caller's buffer is too small; the length needed is given back */
    CSIM_E_HALTED = -6,  /* collided or stopped: csim_resume or csim_reset first */
    CSIM_E_SNAPSHOT = -7 /* the snapshot belongs to another simulation */
};

/* The constant's name, "CSIM_E_ARG" and so on; "CSIM_E_UNKNOWN" for anything else. */
CSIM_API const char *csim_error_name(int code);

/* What the thread's latest failed call found wrong, in one line; "" if none failed. */
CSIM_API const char *csim_last_error_text(void);

/* ---- Life ---- */

/* What a simulation begins with; start from CSIM_OPTIONS_INIT. */
typedef struct {
    size_t size;        /* sizeof(csim_options) */
    fc_context *faults; /* borrowed, its clock is set to simulated time; NULL: one of its own */
    uint64_t seed;      /* of the simulation's own fault context; ignored when faults is given */
    int threads;        /* that a run may use, 1..64 */
    bool brute_force;   /* test all pairs instead of a grid: for tests, same bits */
    const char *build;  /* of csim_build_at: for tests, same bits; NULL: the fastest */
} csim_options;

/* A fault context of its own, seed 1, one thread. */
/* clang-format off */
#define CSIM_OPTIONS_INIT {sizeof(csim_options), NULL, 1, 1, false, NULL}
/* clang-format on */

/* Names of the builds of the inner loops that this machine can run, "sse2" and so on, the fastest
 * last; NULL beyond them. */
CSIM_API const char *csim_build_at(int index);

/* An empty world at time 0; options may be NULL. NULL with CSIM_E_ARG or CSIM_E_NOMEM in
 * csim_last_error_text. */
CSIM_API csim *csim_new(const csim_options *options);

/* NULL is allowed; the default simulation is left alone. */
CSIM_API void csim_free(csim *sim);

/* The simulation behind coptersim_wrapper.h, made at the first use, on fc_default(). */
CSIM_API csim *csim_default(void);

/* Back to the state after csim_new: no copters, lines or anchors, time 0, default parameters, no
 * faults (a borrowed fault context is left as it is). */
CSIM_API int csim_reset(csim *sim);

/* The fault context: arm faults on the names that section 11 of docs/coptersim.md lists. */
CSIM_API fc_context *csim_faults(csim *sim);

/* ---- Parameters ----
 * All by name, so that scenarios, command lines and models share one table. Switches take 0 and 1,
 * choices the number of the choice. The gains are among them: csim_set gives one to all copters.
 * docs/coptersim.md explains each one. */

/* What values a parameter takes. */
typedef enum { CSIM_REAL, CSIM_SWITCH, CSIM_CHOICE } csim_param_kind;

/* A parameter. */
typedef struct {
    const char *name;           /* as csim_set takes it */
    csim_param_kind kind;       /* what values it takes */
    double min, max, initial;   /* of a CSIM_CHOICE: 0 and the number of choices - 1 */
    const char *unit;           /* "m", "us", "1" ... */
    const char *text;           /* one line */
    const char *const *choices; /* CSIM_CHOICE: names; else NULL */
} csim_param;

/* How many there are; the index-th, or NULL. */
CSIM_API int csim_param_count(void);
CSIM_API const csim_param *csim_param_at(int index);

/* CSIM_E_NAME for an unknown name, CSIM_E_ARG for a value outside the limits. */
CSIM_API int csim_set(csim *sim, const char *name, double value);
/* The value now. */
CSIM_API int csim_get(const csim *sim, const char *name, double *value);
/* The value as text: a number, true/false, or the name of a choice. */
CSIM_API int csim_set_text(csim *sim, const char *name, const char *text);

/* Named sets of parameters: "default", and "hardened" with the counter-measures against faults.
 * The index-th name from 0, or NULL. */
CSIM_API const char *csim_configuration_at(int index);
/* All parameters, gains included, to their initial values or those of the set. */
CSIM_API int csim_configure(csim *sim, const char *configuration);

/* Gains of the estimator (equations 11 to 14; docs/coptersim.md section 5). */
typedef struct {
    double pos_p, pos_i, pos_d; /* of the position */
    double vel_p, vel_i, vel_d; /* of the velocity */
    double acc_p, acc_i, acc_d; /* of the tilt */
    double max_corr;            /* m, largest range error used */
    double max_tilt;            /* degrees, largest tilt estimate */
} csim_gains;

/* Of one copter. Copters added later start with the gains set by csim_set_gains_all. */
CSIM_API int csim_set_gains(csim *sim, int32_t copter, const csim_gains *gains);
CSIM_API int csim_set_gains_all(csim *sim, const csim_gains *gains);
CSIM_API int csim_get_gains(const csim *sim, int32_t copter, csim_gains *gains);

/* ---- The world ---- Ids of copters, lines and anchors are 0..2^31-1, each with a name space of
 * its own; adding an id again replaces it. Coordinates must be finite. */

/* Terrain from (x1, y1) to (x2, y2), m, of any height. */
CSIM_API int csim_add_line(csim *sim, int32_t id, double x1, double y1, double x2, double y2);
/* Remove all lines. */
CSIM_API int csim_clear_lines(csim *sim);
/* An anchor that copters range to, at (x, y, z), m. */
CSIM_API int csim_add_anchor(csim *sim, int32_t id, double x, double y, double z);
/* Remove all anchors. */
CSIM_API int csim_clear_anchors(csim *sim);

/* ---- Copters ---- */

/* The state of a copter. */
typedef struct {
    double px, py, pz;       /* m, world */
    double vx, vy;           /* m/s, world */
    double roll, pitch, yaw; /* degrees */
    double e_r, e_p;         /* degrees, tilt estimates; 0 in a true state */
} csim_state;

/* Where it is, or where it believes to be. */
typedef enum { CSIM_TRUE, CSIM_PERCEIVED } csim_view;

/* At rest, level, with both states equal. yaw in degrees. */
CSIM_API int csim_add_copter(csim *sim, int32_t id, double px, double py, double yaw);
/* Remove one copter, or all. What others know of it they keep until it expires. */
CSIM_API int csim_remove_copter(csim *sim, int32_t id);
CSIM_API int csim_clear_copters(csim *sim);
/* How many copters there are. */
CSIM_API int csim_count(const csim *sim);

/* The pilot's command from now on: roll, pitch and yaw rate in -1..1, throttle in 0..1 (without
 * effect), clamped; not NaN. */
CSIM_API int csim_command(csim *sim, int32_t copter, double roll, double pitch, double yaw,
                          double throttle);

/* Read or replace a state of a copter. */
CSIM_API int csim_get_state(const csim *sim, int32_t copter, csim_view view, csim_state *state);
CSIM_API int csim_set_state(csim *sim, int32_t copter, csim_view view, const csim_state *state);

/* What the automatic avoidance of a copter does. */
typedef struct {
    bool active;          /* the latest step followed the override, not the pilot */
    double roll, pitch;   /* its command, -1..1 */
    uint64_t steps;       /* in which it was active so far */
    uint64_t rejected;    /* range samples that the gate refused */
    double max_pos_error; /* m, largest |true - perceived| position so far, at ends of steps */
} csim_station;

/* What the avoidance does now. */
CSIM_API int csim_override(const csim *sim, int32_t copter, csim_station *station);

/* Columns of all copters in ascending order of id, valid until the next call that is not const.
 * Each array has count elements. */
typedef struct {
    int count;                                                             /* of copters */
    const int32_t *id;                                                     /* ascending */
    const double *px, *py, *pz, *vx, *vy, *roll, *pitch, *yaw, *e_r, *e_p; /* as csim_state */
    const uint8_t *override_active;     /* 0 or 1, as csim_station */
    const double *set_roll, *set_pitch; /* the command that the latest step followed, -1..1 */
} csim_columns_view;

/* The columns of one view. */
CSIM_API int csim_columns(const csim *sim, csim_view view, csim_columns_view *columns);

/* A distance that a copter measured. */
typedef struct {
    int32_t anchor;  /* to this one */
    double measured; /* m */
    double expected; /* m, from the perceived position before the correction */
    bool used;       /* it corrected the position; else the gate refused it */
    uint64_t t_us;   /* end of the step */
} csim_range;

/* The latest distance that a copter measured to each anchor it has ranged to, in the order in which
 * the anchors were added. Count as in csim_collisions. */
CSIM_API int csim_ranges(const csim *sim, int32_t copter, csim_range *list, size_t *count);

/* ---- Running ---- */

/* Whether csim_run may go on. */
typedef enum { CSIM_RUNNING, CSIM_COLLIDED, CSIM_STOPPED } csim_run_state;

/* Run steps steps of dt_us microseconds (1..1e9). Messages go out every its_div steps, one anchor
 * is used every anchor_div steps (<= 1: every step). With halt_on_collision the run ends with the
 * completed step of the collision, and later calls do nothing but return CSIM_E_HALTED. */
CSIM_API int csim_run(csim *sim, uint64_t steps, uint64_t dt_us, int its_div, int anchor_div);

CSIM_API uint64_t csim_time(const csim *sim);         /* us */
CSIM_API csim_run_state csim_status(const csim *sim); /* now */
CSIM_API int csim_stop(csim *sim);                    /* also from csim_on_step */
CSIM_API int csim_resume(csim *sim);                  /* forget the collisions, run on */

/* What a copter ran into. */
typedef enum { CSIM_TERRAIN, CSIM_COPTER } csim_collision_kind;

/* A collision of true states. */
typedef struct {
    csim_collision_kind kind; /* with what */
    int32_t id, other;        /* copter; the line, or the copter with the larger id */
    uint64_t t_us;            /* end of the step */
    double x, y;              /* m: midpoint, or the closest point of the line */
} csim_collision;

/* How many collisions were recorded since csim_resume or csim_reset; the first *count of them are
 * written to list when it is not NULL and *count says how long it is. In order of time, then
 * smaller id, terrain first, other id. Returns CSIM_E_SPACE when there are more; *count is then
 * their number. */
CSIM_API int csim_collisions(const csim *sim, csim_collision *list, size_t *count);

/* Called after each completed step, on the thread that called csim_run. A result other than 0
 * stops. */
typedef int (*csim_step_fn)(void *user, csim *sim);
CSIM_API int csim_on_step(csim *sim, csim_step_fn step, void *user);

/* ---- How close it came (the objective of a guided search; docs/search.md) ---- */

/* How closeness is measured. */
typedef enum {
    CSIM_GAP,  /* m: distance of the true positions minus 0.8 (copters) or 0.4 (lines) */
    CSIM_STOP, /* the same minus closing speed^2 / (2 a): room left after braking fully */
    CSIM_LATE  /* gap + 0.3 m t/T */
} csim_closeness_kind;

/* The closest that copters came to a collision. */
typedef struct {
    double value;  /* smallest so far; infinity when there was nothing to come close to */
    uint64_t t_us; /* when */
    csim_collision_kind kind; /* to what */
    int32_t id, other;        /* who */
} csim_closeness;

/* Forget what was measured, and measure from now on at the end of every step. horizon_us is the T
 * of CSIM_LATE. Part of a snapshot. */
CSIM_API int csim_watch_closeness(csim *sim, csim_closeness_kind kind, uint64_t horizon_us);
/* The closest so far. */
CSIM_API int csim_closest(const csim *sim, csim_closeness *closest);

/* ---- What a copter knows of others ---- */

/* What an entry of a local dynamic map is about. */
typedef enum { CSIM_ENTRY_COPTER, CSIM_ENTRY_LINE, CSIM_ENTRY_COMFORT } csim_entry_kind;

/* An entry of a local dynamic map. */
typedef struct {
    csim_entry_kind kind; /* what it is about */
    int32_t id;           /* of the copter or line */
    uint64_t stamp_us;    /* of a copter's message */
    double x, y;          /* m, extrapolated position, midpoint of a line, own position */
    double vx, vy;        /* m/s */
    double cx, cy;        /* m, centre of the risk contour */
    double along, across; /* m, its semi-axes */
    double angle;         /* degrees, direction of the first semi-axis */
    bool overlap;         /* with the own comfort zone */
} csim_ldm_entry;

/* The local dynamic map of one copter as the next step would see it: own zone, copters and lines in
 * ascending id. Count as in csim_collisions. */
CSIM_API int csim_ldm(const csim *sim, int32_t copter, csim_ldm_entry *entries, size_t *count);

/* ---- ITS messages (docs/coptersim.md section 7) ---- */

enum { CSIM_MESSAGE_BYTES = 92 };

/* What a copter tells the others. */
typedef struct {
    int32_t id;        /* of the copter */
    uint64_t stamp_us; /* when it was sent */
    csim_state state;  /* as the copter perceives it */
} csim_message;

/* The message as bytes. */
CSIM_API int csim_pack(const csim_message *message, uint8_t bytes[CSIM_MESSAGE_BYTES]);
/* Any bytes are accepted; len other than CSIM_MESSAGE_BYTES is CSIM_E_ARG. */
CSIM_API int csim_unpack(const uint8_t *bytes, size_t len, csim_message *message);

/* ---- Snapshots ---- */

/* The whole state of a simulation at one moment. */
typedef struct csim_snapshot csim_snapshot;

/* Everything, faults, queues and random streams of its own fault context included. NULL when memory
 * is exhausted, or when the fault context is borrowed. Free with csim_release. */
CSIM_API csim_snapshot *csim_save(const csim *sim);
/* Put it back: any number of times, into the simulation it was taken from (CSIM_E_SNAPSHOT
 * otherwise). */
CSIM_API int csim_restore(csim *sim, const csim_snapshot *snapshot);
/* Forget it; NULL is allowed. */
CSIM_API void csim_release(csim_snapshot *snapshot);

#ifdef __cplusplus
}
#endif

#endif
