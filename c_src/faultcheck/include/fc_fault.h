/* fc_fault.h: the fault models and arming them on probes. Part of fc.h. */
#ifndef FC_FAULT_H
#define FC_FAULT_H

#include "fc_context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* x is the value entering the fault. A window starts at the first affected call after arming,
 * after a change of the trigger or after an unaffected call; k is the number of affected calls
 * before this one in the window. Integers are computed in double, truncated toward zero and
 * saturated at the type's limits; 64-bit integers with an integral parameter of OFFSET,
 * AMPLIFICATION and SET_TO exactly. */
typedef enum {
    FC_BITFLIP,        /* bit n; 0 is the least significant */
    FC_BITFLIP_RANDOM, /* one bit, drawn anew */
    FC_STUCK,          /* the value of the window's first call, per type */
    FC_STUCK_BIT,      /* bit n is a (0 or 1) */
    FC_AMPLIFICATION,  /* x * a */
    FC_OFFSET,         /* x + a */
    FC_SET_TO,         /* a */
    FC_NOISE_UNIFORM,  /* x + a * (2 * unit - 1) */
    FC_NOISE_GAUSS,    /* x + a * gauss */
    FC_RANDOM_OFFSET,  /* x + a + (b - a) * unit */
    FC_DRIFT,          /* x + a * (k + 1), the drift limited to +-b */
    FC_DRIFT_TIMED,    /* x + a * seconds since the window's first call, limited to +-b */
    FC_RAMP,           /* from the window's first x to a in n calls */
    FC_DELAY,          /* the input n affected calls ago; before that the window's first input */
    FC_QUANTISE,       /* a * floor(x / a + 0.5) */
    FC_DEAD_ZONE,      /* a if abs(x - a) < b */
    FC_SATURATE,       /* a <= x <= b */
    FC_OSCILLATE,      /* x + a * sin(2 * pi * k / n) */
    FC_DROPOUT,        /* with probability a, by mode n: FC_HOLD, FC_ZERO or FC_NAN */
    FC_SPIKE,          /* with probability a: x + b or x - b */
    FC_HELD_OFFSET     /* x + a + (b - a) * unit, drawn by the first call of each n nanoseconds */
} fc_model_kind;

enum {
    FC_HOLD = 0, /* the last value that got through; the first input if none did */
    FC_ZERO = 1, /* 0 */
    FC_NAN = 2   /* floats only */
};

/* A model with its parameters; those that the model does not mention are ignored. */
typedef struct {
    int kind;  /* fc_model_kind */
    double a;  /* as the model says */
    double b;  /* as the model says */
    int64_t n; /* as the model says */
} fc_model;

/* Arm a model on a probe. A fault id; FC_E_NOMEM; FC_E_BIT for a bit below 0; FC_E_ARG for a
 * parameter outside its range: n >= 0 for DELAY, n >= 1 for RAMP and OSCILLATE, a > 0 for QUANTISE,
 * 0 <= a <= 1 for DROPOUT and SPIKE, a <= b for SATURATE, RANDOM_OFFSET and
 * HELD_OFFSET, n >= 1 for that, b >= 0 for DRIFT, a NaN except in AMPLIFICATION, OFFSET and SET_TO.
 * The functions below give the same results. */
FC_API fc_fault_id fc_add_model(fc_context *ctx, const char *id, const fc_model *model);

/* Invert a bit, 0 the least significant. */
FC_API fc_fault_id fc_add_bitflip(fc_context *ctx, const char *id, int bit);

/* Invert a bit that is drawn anew for each affected call. */
FC_API fc_fault_id fc_add_bitflip_random(fc_context *ctx, const char *id);

/* Hold the value of the window's first call. */
FC_API fc_fault_id fc_add_stuck(fc_context *ctx, const char *id);

/* Force a bit. */
FC_API fc_fault_id fc_add_stuck_bit(fc_context *ctx, const char *id, int bit, bool value);

/* Multiply. */
FC_API fc_fault_id fc_add_amplification(fc_context *ctx, const char *id, double factor);

/* Add a constant. */
FC_API fc_fault_id fc_add_offset(fc_context *ctx, const char *id, double constant);

/* Replace by a value. */
FC_API fc_fault_id fc_add_set_to(fc_context *ctx, const char *id, double value);

/* Add even noise between -amplitude and amplitude. */
FC_API fc_fault_id fc_add_noise_uniform(fc_context *ctx, const char *id, double amplitude);

/* Add normal noise of that standard deviation; never more than six of them. */
FC_API fc_fault_id fc_add_noise_gauss(fc_context *ctx, const char *id, double deviation);

/* Add a number drawn evenly between low and high. */
FC_API fc_fault_id fc_add_random_offset(fc_context *ctx, const char *id, double low, double high);

/* Add per_call more at each affected call, at most limit in all (INFINITY: no limit). */
FC_API fc_fault_id fc_add_drift(fc_context *ctx, const char *id, double per_call, double limit);

/* Add per_second for each second of context time since the window's first call, at most limit. */
FC_API fc_fault_id fc_add_drift_timed(fc_context *ctx, const char *id, double per_second,
                                      double limit);

/* Go from the window's first value to target in that many calls. */
FC_API fc_fault_id fc_add_ramp(fc_context *ctx, const char *id, double target, int64_t calls);

/* Give the value of that many affected calls ago. */
FC_API fc_fault_id fc_add_delay(fc_context *ctx, const char *id, int64_t calls);

/* Round to multiples of step. */
FC_API fc_fault_id fc_add_quantise(fc_context *ctx, const char *id, double step);

/* Give centre for all values closer to it than width. */
FC_API fc_fault_id fc_add_dead_zone(fc_context *ctx, const char *id, double centre, double width);

/* Limit to low..high. */
FC_API fc_fault_id fc_add_saturate(fc_context *ctx, const char *id, double low, double high);

/* Add a sine with a period of that many calls. */
FC_API fc_fault_id fc_add_oscillate(fc_context *ctx, const char *id, double amplitude,
                                    int64_t calls);

/* With that probability give what mode says: FC_HOLD, FC_ZERO or FC_NAN. */
FC_API fc_fault_id fc_add_dropout(fc_context *ctx, const char *id, double probability, int mode);

/* With that probability add or subtract height. */
FC_API fc_fault_id fc_add_spike(fc_context *ctx, const char *id, double probability, double height);

/* Add a number drawn evenly between low and high, and held: drawn at the window's first call, and
 * again by the first call of each period of that many nanoseconds since then. */
FC_API fc_fault_id fc_add_held_offset(fc_context *ctx, const char *id, double low, double high,
                                      int64_t ns);

/* The fault added last to id, or FC_E_NO_FAULT if there is none or the latest was refused. */
FC_API fc_fault_id fc_latest(fc_context *ctx, const char *id);

/* Disarm one identifier, or all. */
FC_API void fc_remove_probe_faults(fc_context *ctx, const char *id);
FC_API void fc_remove_all_probe_faults(fc_context *ctx);

#ifdef __cplusplus
}
#endif

#endif
