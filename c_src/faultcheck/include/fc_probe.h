/* fc_probe.h: the probes a program passes its values through. Part of fc.h; enough for the code
 * under test. */
#ifndef FC_PROBE_H
#define FC_PROBE_H

#include "fc_context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The types of probed values. */
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
/* Bit b is bit b%8 of byte b/8. SET_TO 0..255 fills; STUCK and DELAY hold whole contents; models
 * that compute do not apply (FC_E_TYPE). */
FC_API int fc_probe_bytes(fc_context *ctx, const char *id, void *data, size_t len);

/* How many faults of id were triggered in its most recent probe call. */
FC_API int fc_num_active(fc_context *ctx, const char *id);

/* Handles: FC_PROBE_F64("id", &x) probes the default context. A static handle at the call site
 * remembers the record, so an idle call costs one relaxed atomic load of the record's state and
 * one predicted branch. The identifier must be a string literal. With FC_DISABLE defined the
 * macros compile to nothing. */
typedef struct {
    const unsigned char *state; /* points to 0 while the probe is idle */
    void *probe;                /* the record; the library's own */
    fc_context *context;        /* NULL: the default one */
} fc_handle;

/* What the macros, and the probes of fc_resolve.h, call when the probe is not idle, or not known
 * yet. id is only read in a handle that is not resolved. Results as fc_probe_. */
FC_API int fc_handle_f32(fc_handle *handle, const char *id, float *value);
FC_API int fc_handle_f64(fc_handle *handle, const char *id, double *value);
FC_API int fc_handle_i8(fc_handle *handle, const char *id, int8_t *value);
FC_API int fc_handle_i16(fc_handle *handle, const char *id, int16_t *value);
FC_API int fc_handle_i32(fc_handle *handle, const char *id, int32_t *value);
FC_API int fc_handle_i64(fc_handle *handle, const char *id, int64_t *value);
FC_API int fc_handle_u8(fc_handle *handle, const char *id, uint8_t *value);
FC_API int fc_handle_u16(fc_handle *handle, const char *id, uint16_t *value);
FC_API int fc_handle_u32(fc_handle *handle, const char *id, uint32_t *value);
FC_API int fc_handle_u64(fc_handle *handle, const char *id, uint64_t *value);
FC_API int fc_handle_bool(fc_handle *handle, const char *id, bool *value);
FC_API int fc_handle_bytes(fc_handle *handle, const char *id, void *data, size_t len);

#ifdef FC_DISABLE
#define FC_PROBE_WITH_(function, id, value) ((void)sizeof(value))
#else
static const unsigned char fc_handle_new_ __attribute__((unused)) = 1;
#define FC_PROBE_WITH_(function, id, value)                                                        \
    do {                                                                                           \
        static fc_handle fc_handle_ = {&fc_handle_new_, NULL, NULL};                               \
        const unsigned char *fc_state_ = __atomic_load_n(&fc_handle_.state, __ATOMIC_RELAXED);     \
        if (__builtin_expect(__atomic_load_n(fc_state_, __ATOMIC_RELAXED) != 0, 0))                \
            function(&fc_handle_, "" id "", value);                                                \
    } while (0)
#endif

/* A probe of the default context: id a string literal, value a pointer to that type. */
#define FC_PROBE_F32(id, value) FC_PROBE_WITH_(fc_handle_f32, id, value)
#define FC_PROBE_F64(id, value) FC_PROBE_WITH_(fc_handle_f64, id, value)
#define FC_PROBE_I8(id, value) FC_PROBE_WITH_(fc_handle_i8, id, value)
#define FC_PROBE_I16(id, value) FC_PROBE_WITH_(fc_handle_i16, id, value)
#define FC_PROBE_I32(id, value) FC_PROBE_WITH_(fc_handle_i32, id, value)
#define FC_PROBE_I64(id, value) FC_PROBE_WITH_(fc_handle_i64, id, value)
#define FC_PROBE_U8(id, value) FC_PROBE_WITH_(fc_handle_u8, id, value)
#define FC_PROBE_U16(id, value) FC_PROBE_WITH_(fc_handle_u16, id, value)
#define FC_PROBE_U32(id, value) FC_PROBE_WITH_(fc_handle_u32, id, value)
#define FC_PROBE_U64(id, value) FC_PROBE_WITH_(fc_handle_u64, id, value)
#define FC_PROBE_BOOL(id, value) FC_PROBE_WITH_(fc_handle_bool, id, value)

#ifdef __cplusplus
}
#endif

#endif
