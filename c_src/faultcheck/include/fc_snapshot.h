/* fc_snapshot.h: the state of a context, kept and put back. Part of fc.h.
 *
 * A snapshot holds everything that decides how faults act from then on: the faults armed with their
 * ids, triggers, counters, memories and random streams; queued packets, with those that a delay
 * hides; subscriptions; names seen and calls counted; the seed, the error counter, the manual clock
 * and the choice of fc_count_calls. After fc_restore everything goes on bit by bit as it did after
 * fc_save.
 *
 * Not part of it: recordings, callbacks, the choice of the clock and a clock or predicate of the
 * user. Restoring leaves a recording under way as it is.
 *
 * Idle identifiers cost a few bytes and nanoseconds each, so saving and restoring mostly cost what
 * is armed and queued. While another thread probes or arms, each identifier is kept and put back as
 * a whole, but not all of them at the same moment. */
#ifndef FC_SNAPSHOT_H
#define FC_SNAPSHOT_H

#include "fc_context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The state of a context at one moment. */
typedef struct fc_snapshot fc_snapshot;

/* The state of the context now; NULL when memory is exhausted (FC_E_NOMEM in fc_last_error). Free
 * it with fc_release. */
FC_API fc_snapshot *fc_save(fc_context *ctx);

/* Put it back, any number of times. FC_OK; FC_E_ARG when the snapshot is NULL or that of another
 * context; FC_E_NOMEM, with nothing changed. Fault ids given since fc_save are given again. */
FC_API int fc_restore(fc_context *ctx, const fc_snapshot *snapshot);

/* Forget it; the context may be gone already. NULL is allowed. */
FC_API void fc_release(fc_snapshot *snapshot);

#ifdef __cplusplus
}
#endif

#endif
