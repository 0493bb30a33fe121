/* faultcheck_wrapper.h: probes and their faults, as in the fault injector of the thesis.
 *
 * Everything here acts on the default context of fc.h. Identifiers are byte strings compared
 * exactly; NULL equals "". A call that cannot do what it says has no effect; fc_last_error() and
 * the error callback of fc.h tell why. */
#ifndef FAULTCHECK_WRAPPER_H
#define FAULTCHECK_WRAPPER_H

#include "faultcheck_types.h"
#include "fc_export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Flip one bit, 0 the least significant. 0..63; an int has bits 0..31, a double 0..63. */
FC_API void faultcheck_addFaultBitFlip(const char *identifier, int bitToFlip);

/* Flip one bit drawn anew at each affected call, over the full width of the probed type. */
FC_API void faultcheck_addFaultBitFlipRandom(const char *identifier);

/* Hold the value seen at the first affected call. */
FC_API void faultcheck_addFaultStuckToCurrent(const char *identifier);

/* Multiply by a factor, add a constant, replace by a value. Ints: computed in double, truncated
 * toward zero, saturated. */
FC_API void faultcheck_addFaultAmplification(const char *identifier, double factor);
FC_API void faultcheck_addFaultOffset(const char *identifier, double constant);
FC_API void faultcheck_addFaultSetTo(const char *identifier, double value);

/* The three below act on the fault added last to the identifier. */

/* The first `iterations` probe calls from now are unaffected, then exactly one is affected. */
FC_API void faultcheck_setTriggerOnceAfterIterations(const char *identifier,
                                                     unsigned long iterations);

/* The first `iterations` probe calls from now are unaffected, all later ones are affected. */
FC_API void faultcheck_setTriggerAfterIterations(const char *identifier, unsigned long iterations);

/* How many calls are affected once triggered: 0 none, negative without limit. */
FC_API void faultcheck_setDurationAfterTrigger(const char *identifier, int iterations);

/* Disarm one identifier, or all. */
FC_API void faultcheck_removeAllFaultsIdentifier(const char *identifier);
FC_API void faultcheck_removeAllFaults(void);

/* The probes: alter *integer or *value as the armed faults say. */
FC_API void faultcheck_injectFaultInt(const char *identifier, int *integer);
FC_API void faultcheck_injectFaultDouble(const char *identifier, double *value);

/* How many faults of the identifier were triggered in its most recent probe call. */
FC_API int faultcheck_numActiveFaults(const char *identifier);

/* The default context (fc_default()), never NULL, always the same. */
FC_API void *faultcheck_instance(void);

#ifdef __cplusplus
}
#endif

#endif
