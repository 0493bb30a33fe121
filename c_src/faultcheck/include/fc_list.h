/* fc_list.h: what a context has seen and what is armed in it. Part of fc.h. */
#ifndef FC_LIST_H
#define FC_LIST_H

#include "fc_context.h"
#include "fc_record.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Where the iteration window of a fault stands. */
typedef enum {
    FC_WAITING,   /* calls are left before the first affected one */
    FC_ACTIVE,    /* the iteration window is open; other triggers may still hold it back */
    FC_EXHAUSTED, /* the duration is used up */
    FC_DISABLED   /* by fc_enable */
} fc_trigger_state;

/* A fault; one on a channel that is met at gets is listed once for each receiver. */
typedef struct {
    fc_fault_id id;         /* as the function gave that added it */
    const char *model;      /* "offset", "drop", ... */
    double a;               /* parameters as in fc_model */
    double b;               /* the same */
    int64_t n;              /* byte, count or position of a fault on a channel */
    const char *receiver;   /* of a fault met at gets; else "" */
    fc_trigger_state state; /* now */
    uint64_t calls_left;    /* FC_WAITING */
    uint64_t triggered;     /* calls that met it, triggers open */
    uint64_t applied;       /* of those, value changed or not */
    uint64_t skipped;       /* of those */
    int last_error;         /* of the skipped ones, or FC_OK */
} fc_listed_fault;

/* An identifier or a channel. What it points to is valid during the visit only. */
typedef struct {
    const char *id;                /* its name */
    bool is_channel;               /* probes and channels have separate name spaces */
    uint32_t types;                /* bit T: probed or monitored as the fc_type T */
    uint64_t calls;                /* probe and monitor calls, while counted; gets */
    uint64_t puts;                 /* of a channel */
    const fc_listed_fault *faults; /* in the order of adding */
    size_t fault_count;            /* of them */
} fc_listed;

/* Called for each identifier and channel. */
typedef void (*fc_list_fn)(void *user, const fc_listed *listed);

/* Every identifier and channel seen or armed since fc_new or fc_reset, sorted by name, probes
 * before channels of the same name. FC_OK, FC_E_NOMEM; FC_E_ARG for visit NULL. */
FC_API int fc_list(fc_context *ctx, fc_list_fn visit, void *user);

/* The same for callers that cannot give a function: a copy, made at one moment. */
typedef struct fc_listing fc_listing;

/* NULL when memory is exhausted (FC_E_NOMEM in fc_last_error). */
FC_API fc_listing *fc_listing_new(fc_context *ctx);
/* The at-th entry, from 0, valid until fc_listing_free; NULL behind the last. */
FC_API const fc_listed *fc_listing_at(const fc_listing *listing, size_t at);
/* NULL is allowed. */
FC_API void fc_listing_free(fc_listing *listing);

/* The same as one JSON object a line. FC_OK; FC_E_ARG for line NULL; FC_E_NOMEM, perhaps after some
 * of the lines. */
FC_API int fc_dump_json(fc_context *ctx, fc_line_fn line, void *user);

/* Calls of idle identifiers are counted only while this is on: otherwise an idle probe is one load.
 * Armed, monitored and recorded identifiers are always counted. */
FC_API void fc_count_calls(fc_context *ctx, bool on);

/* A number that is another one after any fault was armed or removed, counting or recording
 * switched, or the context reset: a program with many identifiers need not ask each of them at
 * every step, but calls fc_list again when this number has changed. One load. */
FC_API uint64_t fc_change_count(fc_context *ctx);

/* True while calls are counted or recorded, so that also idle identifiers want to be called. */
FC_API bool fc_is_watching(fc_context *ctx);

#ifdef __cplusplus
}
#endif

#endif
