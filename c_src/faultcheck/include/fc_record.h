/* fc_record.h: watching values, recording them, comparing a run with a golden one. Part of fc.h. */
#ifndef FC_RECORD_H
#define FC_RECORD_H

#include "fc_context.h"
#include "fc_probe.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Monitors: recorded and counted like probes, but they never change a value. FC_OK, FC_E_NOMEM;
 * FC_E_ARG for data NULL with len > 0. */
FC_API int fc_monitor_f32(fc_context *ctx, const char *id, float value);
FC_API int fc_monitor_f64(fc_context *ctx, const char *id, double value);
FC_API int fc_monitor_i8(fc_context *ctx, const char *id, int8_t value);
FC_API int fc_monitor_i16(fc_context *ctx, const char *id, int16_t value);
FC_API int fc_monitor_i32(fc_context *ctx, const char *id, int32_t value);
FC_API int fc_monitor_i64(fc_context *ctx, const char *id, int64_t value);
FC_API int fc_monitor_u8(fc_context *ctx, const char *id, uint8_t value);
FC_API int fc_monitor_u16(fc_context *ctx, const char *id, uint16_t value);
FC_API int fc_monitor_u32(fc_context *ctx, const char *id, uint32_t value);
FC_API int fc_monitor_u64(fc_context *ctx, const char *id, uint64_t value);
FC_API int fc_monitor_bool(fc_context *ctx, const char *id, bool value);
FC_API int fc_monitor_bytes(fc_context *ctx, const char *id, const void *data, size_t len);

/* Record every probe and monitor call and every packet put and delivered from now on: into the
 * file, or into memory when file is NULL. A recording under way is stopped first. FC_OK, FC_E_IO,
 * FC_E_NOMEM. */
FC_API int fc_record_start(fc_context *ctx, const char *file);

/* End the recording. FC_OK, also when there is none; FC_E_IO or FC_E_NOMEM when it is incomplete.
 */
FC_API int fc_record_stop(fc_context *ctx);

/* The recording in memory, under way or stopped: copies at most capacity bytes to data, none if it
 * is NULL, and returns the length of all of it. 0 when there is none. */
FC_API size_t fc_record_copy(fc_context *ctx, void *data, size_t capacity);

/* The text form of a recording: line is called with one JSON object each, floats in C99
 * hexadecimal, bytes in hexadecimal. FC_OK; FC_E_ARG for recording NULL with len > 0 or line NULL;
 * FC_E_FORMAT (fc_last_error_text() names the position) or FC_E_NOMEM, after the lines up to there.
 */
typedef void (*fc_line_fn)(void *user, const char *line);
FC_API int fc_record_text(const void *recording, size_t len, fc_line_fn line, void *user);

/* What counts as the same value. */
typedef struct {
    double absolute; /* values differ when abs(a - b) > absolute + relative * abs(golden) */
    double relative; /* as a fraction of the golden value */
} fc_tolerance;

/* How the calls of one identifier or channel differ. */
typedef struct {
    const char *id;          /* its name */
    bool is_channel;         /* packets delivered are compared then */
    uint64_t calls;          /* that both recordings have */
    uint64_t differing;      /* of those */
    uint64_t first;          /* number of the first diverging call, from 0 */
    int64_t first_ns;        /* its context time in the run; in the golden one if it is missing */
    uint64_t missing;        /* calls that only the golden recording has */
    uint64_t extra;          /* calls that only the run has */
    double largest_absolute; /* differences of numbers */
    double largest_relative; /* the same, divided by the golden value */
} fc_divergence;

/* Compare by identifier and call number the values after the faults. visit is called for each
 * identifier that differs, in the order of the first divergences in the run: the way the error
 * propagated. tolerance NULL: none. NaN equals NaN. Returns how many differ; FC_E_ARG for visit or
 * a recording NULL, or a tolerance that is not a number >= 0; FC_E_FORMAT; FC_E_NOMEM. */
typedef void (*fc_divergence_fn)(void *user, const fc_divergence *divergence);
FC_API int fc_compare(const void *golden, size_t golden_len, const void *run, size_t run_len,
                      const fc_tolerance *tolerance, fc_divergence_fn visit, void *user);

/* The same for callers that cannot give a function. */
typedef struct fc_comparison fc_comparison;

/* NULL on an error (fc_last_error), as fc_compare. */
FC_API fc_comparison *fc_comparison_new(const void *golden, size_t golden_len, const void *run,
                                        size_t run_len, const fc_tolerance *tolerance);
/* The at-th divergence, from 0, valid until fc_comparison_free; NULL behind the last. */
FC_API const fc_divergence *fc_comparison_at(const fc_comparison *comparison, size_t at);
/* NULL is allowed. */
FC_API void fc_comparison_free(fc_comparison *comparison);

#ifdef __cplusplus
}
#endif

#endif
