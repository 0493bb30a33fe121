/* fc_threads.h: calls of libfaultcheck on several threads at once, many times over. For tests.
 *
 * A plan is a list of calls for each lane: lane 0 runs first, on the caller's thread; then the
 * lanes 1..threads, at once, on a thread each; then lane threads + 1, on the caller's thread. All
 * calls are made on the default context, which is reset before each repetition.
 *
 *   fc_threads *plan = fc_threads_new(2);
 *   fc_threads_put(plan, 1, "c", "a", 1);
 *   fc_threads_put(plan, 2, "c", "b", 1);
 *   fc_threads_paired(plan, 3, FC_THREADS_DEPTH, "c", "");
 *   fc_threads_run(plan, 100, 1);
 *   fc_threads_results(plan)[3 * 7 + 2].value    what the third call gave in repetition 7
 *
 * Results  the functions that add a call return its number, from 0 in the order of adding, or -1:
 *          no memory, a lane or function there is not, or more data than fits
 * Threads  a plan is used by one thread at a time
 */
#ifndef FC_THREADS_H
#define FC_THREADS_H

#include "fc.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { FC_THREADS_DATA = 32, FC_THREADS_MOST = 8 };

typedef struct fc_threads fc_threads;

/* What one call gave. Where times are taken, another call began after this one had returned if its
 * begin is above this one's end. */
typedef struct {
    int64_t value;                       /* what the function returned; 0 if nothing */
    uint64_t size;                       /* bytes of data */
    uint64_t begin;                      /* 0 in the repetitions without times */
    uint64_t end;                        /* 0 in the repetitions without times */
    unsigned char data[FC_THREADS_DATA]; /* the value a probe left, the packet a get delivered */
} fc_threads_result;

/* NULL: no memory, or threads not 1..FC_THREADS_MOST. */
FC_API fc_threads *fc_threads_new(int threads);
FC_API void fc_threads_free(fc_threads *plan);

/* A probe of that type; data is the value as in memory, FC_BYTES as many bytes as wanted. */
FC_API int fc_threads_probe(fc_threads *plan, int lane, fc_type type, const char *id,
                            const void *data, size_t size);
/* FC_PROBE_I32("x", ...) by its static handle. */
FC_API int fc_threads_probe_handle(fc_threads *plan, int lane, int32_t value);

FC_API int fc_threads_put(fc_threads *plan, int lane, const char *channel, const void *data,
                          size_t size);
FC_API int fc_threads_get(fc_threads *plan, int lane, const char *channel, const char *receiver);

/* fc_add_model */
FC_API int fc_threads_arm(fc_threads *plan, int lane, const char *id, const fc_model *model);

/* Functions of a name. */
typedef enum {
    FC_THREADS_NUM_ACTIVE,
    FC_THREADS_LATEST,
    FC_THREADS_REMOVE_ALL,
    FC_THREADS_CHANNEL_LATEST,
    FC_THREADS_CHANNEL_REMOVE_ALL,
    FC_THREADS_CLEAR,
    FC_THREADS_LOSE,
    FC_THREADS_REPEAT_LAST,
    FC_THREADS_BLOCK_GET,
    FC_THREADS_BLOCK_PUT
} fc_threads_of_name;
FC_API int fc_threads_named(fc_threads *plan, int lane, fc_threads_of_name which, const char *name);

/* Functions of a channel and a number. CORRUPTION: of that bit in the first byte. */
typedef enum {
    FC_THREADS_DROP,
    FC_THREADS_REPEAT,
    FC_THREADS_DELAY,
    FC_THREADS_RESEQUENCE,
    FC_THREADS_CORRUPTION
} fc_threads_of_number;
FC_API int fc_threads_numbered(fc_threads *plan, int lane, fc_threads_of_number which,
                               const char *channel, int64_t n);

/* Functions of a channel and another name: a receiver or a channel. */
typedef enum {
    FC_THREADS_DEPTH,
    FC_THREADS_SUBSCRIBE,
    FC_THREADS_MISROUTE,
    FC_THREADS_MASQUERADE
} fc_threads_of_pair;
FC_API int fc_threads_paired(fc_threads *plan, int lane, fc_threads_of_pair which,
                             const char *channel, const char *other);

/* Functions of a fault: the one that call number `armed_by` gave. RANDOM: with probability n / m;
 * ENABLE: n is 0 or 1. */
typedef enum {
    FC_THREADS_AFTER,
    FC_THREADS_ONCE_AFTER,
    FC_THREADS_DURATION,
    FC_THREADS_PERIODIC,
    FC_THREADS_RANDOM,
    FC_THREADS_NONE,
    FC_THREADS_ENABLE,
    FC_THREADS_REMOVE
} fc_threads_of_fault;
FC_API int fc_threads_faulted(fc_threads *plan, int lane, fc_threads_of_fault which, int armed_by,
                              int64_t n, int64_t m);

/* Runs the plan that many times. The seed decides for how many turns of a loop the threads pause in
 * front of each call. Times are taken in every second repetition, since taking them orders the
 * threads' memory accesses. 0, or -1: no memory, or a thread could not be started. */
FC_API int fc_threads_run(fc_threads *plan, int repetitions, uint64_t seed);

/* After fc_threads_run, until the next one: for each repetition the results of all calls in the
 * order of adding. */
FC_API const fc_threads_result *fc_threads_results(const fc_threads *plan);

#ifdef __cplusplus
}
#endif

#endif
