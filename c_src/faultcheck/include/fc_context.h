/* fc_context.h: contexts, their errors, seeds and clocks. Part of fc.h. */
#ifndef FC_CONTEXT_H
#define FC_CONTEXT_H

#include "fc_export.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Identifiers, faults, channels, seed, clock and errors of their own. */
typedef struct fc_context fc_context;

/* Above 0: names one fault of a context until it is removed. Below 0: an FC_E_ code. */
typedef int64_t fc_fault_id;

enum {
    FC_OK = 0,
    FC_E_ARG = -1,      /* an argument outside the range stated at the function */
    FC_E_NOMEM = -2,    /* an allocation failed */
    FC_E_BIT = -3,      /* a bit the value or byte does not have */
    FC_E_INDEX = -4,    /* a byte the packet does not have */
    FC_E_VALUE = -5,    /* the result does not exist in the type: value left as it was */
    FC_E_TYPE = -6,     /* the fault model does not apply to the probed type */
    FC_E_NO_FAULT = -7, /* no such fault, or none on the identifier, or the latest was refused */
    FC_E_SPACE = -8,    /* the caller's buffer is too small */
    FC_E_RECEIVER = -9, /* no such receiver is subscribed to the channel */
    FC_E_BLOCKED = -10, /* a BLOCK fault refused the packet */
    FC_E_IO = -11,      /* a file could not be opened, read or written */
    FC_E_FORMAT = -12   /* not a recording, or a damaged one */
};

/* The constant's name, "FC_E_ARG" and so on; "FC_E_UNKNOWN" for anything else. */
FC_API const char *fc_error_name(int code);

/* What went wrong. text is valid during the callback only. */
typedef struct {
    int code;          /* FC_E_ code */
    fc_fault_id fault; /* the fault that was skipped, or 0 */
    int first;         /* 0 when this fault has met this cause before */
    const char *text;  /* one line: what, where, what would be right */
} fc_error;

/* Told of each error; called without a lock held, from the thread that met it. */
typedef void (*fc_error_fn)(void *user, const fc_error *error);

/* What a context begins with; start from FC_OPTIONS_INIT. */
typedef struct {
    size_t size;          /* sizeof(fc_options) */
    uint64_t seed;        /* of the random streams; fc_reset returns to it */
    fc_error_fn on_error; /* NULL: one line to stderr per fault and cause */
    void *error_user;     /* handed to on_error */
} fc_options;

/* Seed 1, errors to stderr. */
/* clang-format off */
#define FC_OPTIONS_INIT {sizeof(fc_options), 1, NULL, NULL}
/* clang-format on */

/* A new context; options may be NULL. NULL when memory is exhausted or options->size is unknown. */
FC_API fc_context *fc_new(const fc_options *options);

/* End a context that no thread uses any more. NULL is allowed; the default context is refused
 * (FC_E_ARG). */
FC_API void fc_free(fc_context *ctx);

/* The default context, created at the first use, never NULL. The environment variable FC_SEED
 * gives its seed. */
FC_API fc_context *fc_default(void);

/* Faults, queues, counters, names seen, recordings and random streams back to the state after
 * fc_new. Callbacks and the choice of the clock stay. */
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
/* "" if there was none; valid until the thread's next error. */
FC_API const char *fc_last_error_text(void);
/* Forget it. */
FC_API void fc_clear_last_error(void);

/* Nanoseconds from any origin; called without a lock held, from the thread that probes. */
typedef int64_t (*fc_clock_fn)(void *user);

/* The context's clock from now on; NULL: the system's monotonic clock, as in a new context. */
FC_API void fc_set_clock(fc_context *ctx, fc_clock_fn clock, void *user);

/* Move the manual clock, which is the context's clock from the first call on: it starts at 0 and
 * never moves by itself. fc_reset puts it back to 0. */
FC_API void fc_advance(fc_context *ctx, int64_t ns);

/* The time of the context's clock, in nanoseconds. */
FC_API int64_t fc_now(fc_context *ctx);

#ifdef __cplusplus
}
#endif

#endif
