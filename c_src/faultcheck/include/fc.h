/* fc.h: alter values and packets on their way through a program, on command.
 *
 * Contexts   own identifiers, faults, channels, seed and errors; they do not influence each other.
 * A NULL context means the default one, on which also the compatible headers act. Names      are
 * byte strings compared exactly and copied; NULL equals "". Probes and channels have separate name
 * spaces. Results    below 0 are FC_E_ codes, FC_OK is 0, fault ids are above 0. On an error
 * nothing has changed, the context's error counter and the thread's fc_last_error() are set and the
 * error callback is called. Threads    every function may be called from any thread. A probe call,
 * a put and a get are atomic per identifier; a probe call on an identifier without faults takes no
 * lock. Callbacks run without any lock held. Order      a probe call walks the identifier's faults
 * in the order of adding; for each it advances the trigger and, if triggered, applies the fault to
 * the value left by the one before. */
#ifndef FC_H
#define FC_H

#include "fc_export.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct fc_context fc_context;

/* Above 0: names one fault of a context until it is removed. Below 0: an FC_E_ code. */
typedef int64_t fc_fault_id;

enum {
    FC_OK = 0,
    FC_E_ARG = -1,   /* an argument outside the range stated at the function */
    FC_E_NOMEM = -2, /* an allocation failed */
    FC_E_BIT = -3,   /* a bit the value or byte does not have */
    FC_E_INDEX = -4, /* a byte the packet does not have */
    FC_E_VALUE =
        -5, /* the result is not a number and the type is an integer: value left as it was */
    FC_E_TYPE = -6, /* the fault model does not apply to the probed type */
    FC_E_NO_FAULT =
        -7,          /* no such fault, or none on that identifier, or the latest one was refused */
    FC_E_SPACE = -8, /* the caller's buffer is too small */
    FC_E_RECEIVER = -9 /* no such receiver is subscribed to the channel */
};

/* The constant's name, "FC_E_ARG" and so on; "FC_E_UNKNOWN" for anything else. */
FC_API const char *fc_error_name(int code);

/* ---- contexts
 * -----------------------------------------------------------------------------------------------
 */

/* What went wrong. text is valid during the callback only. */
typedef struct {
    int code;          /* FC_E_ code */
    fc_fault_id fault; /* the fault that was skipped, or 0 */
    int first;         /* 0 when this fault has met this cause before */
    const char *text;  /* one line: what, where, what would be right */
} fc_error;

typedef void (*fc_error_fn)(void *user, const fc_error *error);

typedef struct {
    size_t size;          /* sizeof(fc_options) */
    uint64_t seed;        /* of the random streams; fc_reset returns to it */
    fc_error_fn on_error; /* NULL: one line to stderr per fault and cause */
    void *error_user;
} fc_options;

#define FC_OPTIONS_INIT                                                                            \
    { sizeof(fc_options), 1, NULL, NULL }

/* A new context; options may be NULL. Returns NULL when memory is exhausted or options->size is
 * unknown. */
FC_API fc_context *fc_new(const fc_options *options);

/* End a context that no thread uses any more. NULL is allowed; the default context is refused
 * (FC_E_ARG). */
FC_API void fc_free(fc_context *ctx);

/* The default context, created at the first use, never NULL. The environment variable FC_SEED gives
 * its seed. */
FC_API fc_context *fc_default(void);

/* Faults, queues, counters, names seen and random streams back to the state after fc_new. Callbacks
 * stay. */
FC_API void fc_reset(fc_context *ctx);

/* Seed all random streams anew, also those of the faults armed. Each fault owns a stream that
 * depends on the seed, its identifier and its ordinal on it alone. Default 1. */
FC_API void fc_seed(fc_context *ctx, uint64_t seed);

/* on_error NULL: the default, one line to stderr per fault and cause. */
FC_API void fc_set_error_callback(fc_context *ctx, fc_error_fn on_error, void *user);

/* Errors in this context since fc_new or fc_reset. */
FC_API uint64_t fc_error_count(fc_context *ctx);

/* The calling thread's latest error in any context: FC_E_ code, or FC_OK if there was none since
 * fc_clear_last_error. */
FC_API int fc_last_error(void);
FC_API const char *fc_last_error_text(void); /* "" if none; valid until the thread's next error */
FC_API void fc_clear_last_error(void);

/* ---- probes
 * -------------------------------------------------------------------------------------------------
 */

typedef enum {
    FC_F32,
    FC_F64,
    FC_I8,
    FC_I16,
    FC_I32,
    FC_I64,
    FC_U8,
    FC_U16,
    FC_U32,
    FC_U64,
    FC_BOOL,
    FC_BYTES
} fc_type;

/* Pass *value through the faults armed on id. FC_OK; FC_E_ARG for value NULL; FC_E_NOMEM; or the
 * code of the first fault that was skipped in this call (FC_E_BIT, FC_E_VALUE, FC_E_TYPE). */
FC_API int fc_probe_f32(fc_context *ctx, const char *id, float *value);
FC_API int fc_probe_f64(fc_context *ctx, const char *id, double *value);
FC_API int fc_probe_i8(fc_context *ctx, const char *id, int8_t *value);
FC_API int fc_probe_i16(fc_context *ctx, const char *id, int16_t *value);
FC_API int fc_probe_i32(fc_context *ctx, const char *id, int32_t *value);
FC_API int fc_probe_i64(fc_context *ctx, const char *id, int64_t *value);
FC_API int fc_probe_u8(fc_context *ctx, const char *id, uint8_t *value);
FC_API int fc_probe_u16(fc_context *ctx, const char *id, uint16_t *value);
FC_API int fc_probe_u32(fc_context *ctx, const char *id, uint32_t *value);
FC_API int fc_probe_u64(fc_context *ctx, const char *id, uint64_t *value);
FC_API int fc_probe_bool(fc_context *ctx, const char *id, bool *value);
/* Bit b is bit b%8 of byte b/8. Arithmetic models do not apply (FC_E_TYPE); SET_TO 0..255 fills. */
FC_API int fc_probe_bytes(fc_context *ctx, const char *id, void *data, size_t len);

/* How many faults of id were triggered in its most recent probe call. */
FC_API int fc_num_active(fc_context *ctx, const char *id);

/* ---- faults on probes: a fault id, or FC_E_NOMEM, or what is said
 * ------------------------------------------------ */

FC_API fc_fault_id fc_add_bitflip(fc_context *ctx, const char *id, int bit); /* FC_E_BIT if < 0 */
FC_API fc_fault_id fc_add_bitflip_random(fc_context *ctx, const char *id);
/* Hold, per type, the value of the first affected call of a window; a window ends with an
 * unaffected call. */
FC_API fc_fault_id fc_add_stuck(fc_context *ctx, const char *id);
FC_API fc_fault_id fc_add_amplification(fc_context *ctx, const char *id, double factor);
FC_API fc_fault_id fc_add_offset(fc_context *ctx, const char *id, double constant);
FC_API fc_fault_id fc_add_set_to(fc_context *ctx, const char *id, double value);

/* The fault added last to id, or FC_E_NO_FAULT if there is none or the latest addition was refused.
 */
FC_API fc_fault_id fc_latest(fc_context *ctx, const char *id);

/* Disarm one identifier, or all. */
FC_API void fc_remove_probe_faults(fc_context *ctx, const char *id);
FC_API void fc_remove_all_probe_faults(fc_context *ctx);

/* ---- any fault, by id: FC_OK or FC_E_NO_FAULT
 * ----------------------------------------------------------------------- */

/* The first `calls` calls from now are unaffected, all later ones are affected. */
FC_API int fc_trigger_after(fc_context *ctx, fc_fault_id fault, uint64_t calls);
/* The same, but exactly one call is affected. */
FC_API int fc_trigger_once_after(fc_context *ctx, fc_fault_id fault, uint64_t calls);
/* How many calls are affected once triggered: 0 none, negative without limit. */
FC_API int fc_trigger_duration(fc_context *ctx, fc_fault_id fault, int64_t calls);
/* A disabled fault injects nothing and its trigger stands still. */
FC_API int fc_enable(fc_context *ctx, fc_fault_id fault, bool enabled);
FC_API int fc_remove(fc_context *ctx, fc_fault_id fault);

/* ---- channels
 * ------------------------------------------------------------------------------------------------
 */

/* Queue a copy of len bytes for every receiver. FC_OK, FC_E_ARG for data NULL with len > 0,
 * FC_E_NOMEM. */
FC_API int fc_channel_put(fc_context *ctx, const char *channel, const void *data, size_t len);

/* Take the next packet of a receiver ("" or NULL: the one of a channel without subscriptions).
 *   1              delivered: bytes in data, length in *len (len may be NULL)
 *   0              nothing to deliver; data and *len untouched
 *   FC_E_SPACE     capacity is too small: the length needed is in *len, data untouched, packet and
 * triggers as before FC_E_ARG       data is NULL and capacity > 0 FC_E_RECEIVER  that receiver is
 * not subscribed FC_E_NOMEM */
FC_API int fc_channel_get(fc_context *ctx, const char *channel, const char *receiver, void *data,
                          size_t capacity, size_t *len);

/* Give a receiver a queue of its own: it gets every packet put from now on. From the first
 * subscription on, the receiver
 * "" gets no more packets unless it is subscribed too. FC_OK (also when subscribed already),
 * FC_E_NOMEM. */
FC_API int fc_channel_subscribe(fc_context *ctx, const char *channel, const char *receiver);

/* Discard all queued packets of all receivers. */
FC_API void fc_channel_clear(fc_context *ctx, const char *channel);

/* Packets queued for a receiver; 0 for an unknown channel; FC_E_RECEIVER. */
FC_API int64_t fc_channel_depth(fc_context *ctx, const char *channel, const char *receiver);

/* Faults met at each get. A fault id, or FC_E_NOMEM, or what is said. */
FC_API fc_fault_id
fc_channel_add_corruption(fc_context *ctx, const char *channel, int byte,
                          int bit); /* FC_E_INDEX byte < 0, FC_E_BIT bit not 0..7 */
FC_API fc_fault_id fc_channel_add_drop(fc_context *ctx, const char *channel,
                                       int64_t packets); /* FC_E_ARG if < 0 */
FC_API fc_fault_id fc_channel_add_repeat(fc_context *ctx, const char *channel,
                                         int64_t packets); /* FC_E_ARG if < 0 */

FC_API fc_fault_id fc_channel_latest(fc_context *ctx, const char *channel);
FC_API void fc_channel_remove_faults(fc_context *ctx, const char *channel);
FC_API void fc_channel_remove_all_faults(fc_context *ctx);

#ifdef __cplusplus
}
#endif

#endif
