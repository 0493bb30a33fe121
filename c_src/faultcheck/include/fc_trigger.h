/* fc_trigger.h: when a fault is active. Part of fc.h.
 *
 * A fault without trigger is permanent. Several triggers on one fault must all hold. The iteration
 * window counts every call; the random draw is made only when all others hold; the duration is
 * consumed by affected calls only. Results: FC_OK, FC_E_NO_FAULT, or what is said. */
#ifndef FC_TRIGGER_H
#define FC_TRIGGER_H

#include "fc_context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The first `calls` calls from now are unaffected, all later ones are affected. */
FC_API int fc_trigger_after(fc_context *ctx, fc_fault_id fault, uint64_t calls);

/* The same, but exactly one call is affected. */
FC_API int fc_trigger_once_after(fc_context *ctx, fc_fault_id fault, uint64_t calls);

/* How many calls are affected once triggered: 0 none, negative without limit. */
FC_API int fc_trigger_duration(fc_context *ctx, fc_fault_id fault, int64_t calls);

/* While delay <= now - time of this call < delay + duration; negative duration: for ever.
 * FC_E_ARG if delay < 0. */
FC_API int fc_trigger_time(fc_context *ctx, fc_fault_id fault, int64_t delay_ns,
                           int64_t duration_ns);

/* Each call that all other triggers let pass, with that probability. FC_E_ARG if not 0..1. */
FC_API int fc_trigger_random(fc_context *ctx, fc_fault_id fault, double probability);

/* Calls k with k mod period < active, k from 0 at the first call after the delay. FC_E_ARG if
 * period is 0. */
FC_API int fc_trigger_periodic(fc_context *ctx, fc_fault_id fault, uint64_t period,
                               uint64_t active);

/* Whether a fault may act now; called without a lock held. */
typedef bool (*fc_predicate_fn)(void *user);

/* While predicate(user) is true; it is called for each call of the identifier. FC_E_ARG if NULL. */
FC_API int fc_trigger_when(fc_context *ctx, fc_fault_id fault, fc_predicate_fn predicate,
                           void *user);

/* No trigger any more: permanent. */
FC_API int fc_trigger_none(fc_context *ctx, fc_fault_id fault);

/* A disabled fault injects nothing and its triggers stand still. */
FC_API int fc_enable(fc_context *ctx, fc_fault_id fault, bool enabled);

/* Start the fault's random stream anew from a seed of its own, which alone decides it: neither the
 * context's seed nor the identifier nor the order of arming do. A later fc_seed or fc_reset takes
 * that back. */
FC_API int fc_seed_fault(fc_context *ctx, fc_fault_id fault, uint64_t seed);

/* Disarm one fault. */
FC_API int fc_remove(fc_context *ctx, fc_fault_id fault);

#ifdef __cplusplus
}
#endif

#endif
