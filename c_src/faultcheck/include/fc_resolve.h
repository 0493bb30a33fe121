/* fc_resolve.h: probes and channels that are looked up once. Part of fc.h.
 *
 * For programs with many probes whose names are made at run time: resolve each name once, then an
 * idle probe costs one relaxed atomic load and one predicted branch, in any context.
 *
 *     fc_handle px;
 *     fc_resolve(ctx, "PxId7", FC_F64, &px);
 *     fc_probe_f64_at(&px, &value);
 *
 * A resolved handle may be copied, used by several threads at once, and stays good over fc_reset
 * and fc_restore until fc_free of its context. Resolving is no call: nothing is counted or listed.
 */
#ifndef FC_RESOLVE_H
#define FC_RESOLVE_H

#include "fc_channel.h"
#include "fc_context.h"
#include "fc_probe.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Probes ---- */

/* Look up the probe id for values of that fc_type. FC_OK; FC_E_ARG for an unknown type or handle
 * NULL; FC_E_NOMEM. On an error *handle is as before. */
FC_API int fc_resolve(fc_context *ctx, const char *id, int type, fc_handle *handle);

/* True while a call would change, count and record nothing: no fault is armed on the identifier,
 * calls are neither counted nor recorded, and it has been probed as this type since fc_new or
 * fc_reset. */
static inline bool fc_handle_is_idle(const fc_handle *handle) {
    return __atomic_load_n(handle->state, __ATOMIC_RELAXED) == 0;
}

/* As fc_probe_f32 and so on. The handle must have been resolved for the type of the value. */
#define FC_PROBE_AT_(suffix, type)                                                                 \
    static inline int fc_probe_##suffix##_at(fc_handle *handle, type *value) {                     \
        if (__builtin_expect(fc_handle_is_idle(handle), 1))                                        \
            return FC_OK;                                                                          \
        return fc_handle_##suffix(handle, NULL, value);                                            \
    }
FC_PROBE_AT_(f32, float)
FC_PROBE_AT_(f64, double)
FC_PROBE_AT_(i8, int8_t)
FC_PROBE_AT_(i16, int16_t)
FC_PROBE_AT_(i32, int32_t)
FC_PROBE_AT_(i64, int64_t)
FC_PROBE_AT_(u8, uint8_t)
FC_PROBE_AT_(u16, uint16_t)
FC_PROBE_AT_(u32, uint32_t)
FC_PROBE_AT_(u64, uint64_t)
FC_PROBE_AT_(bool, bool)
#undef FC_PROBE_AT_
static inline int fc_probe_bytes_at(fc_handle *handle, void *data, size_t len) {
    if (__builtin_expect(fc_handle_is_idle(handle), 1))
        return FC_OK;
    return fc_handle_bytes(handle, NULL, data, len);
}

/* ---- Channels ---- */

/* A channel that was looked up. */
typedef struct {
    const unsigned char *state; /* points to 0 while the channel is idle */
    void *channel;              /* the library's own */
    fc_context *context;        /* it belongs to */
} fc_channel_handle;

/* Look up a channel. FC_OK; FC_E_ARG for handle NULL; FC_E_NOMEM. On an error *handle is as before.
 */
FC_API int fc_resolve_channel(fc_context *ctx, const char *channel, fc_channel_handle *handle);

/* True while no fault is armed on the channel, no packet is queued for any of its receivers, and
 * its packets are neither counted nor recorded: a put followed by a get would deliver just that
 * packet. A program may then hand the packet over by itself. The channel does not know such a
 * packet: REPEAT_LAST will not repeat it. */
static inline bool fc_channel_is_idle(const fc_channel_handle *handle) {
    return __atomic_load_n(handle->state, __ATOMIC_RELAXED) == 0;
}

/* As fc_channel_put, fc_channel_get and fc_channel_depth. */
FC_API int fc_channel_put_at(const fc_channel_handle *handle, const void *data, size_t len);
FC_API int fc_channel_get_at(const fc_channel_handle *handle, const char *receiver, void *data,
                             size_t capacity, size_t *len);
FC_API int64_t fc_channel_depth_at(const fc_channel_handle *handle, const char *receiver);

#ifdef __cplusplus
}
#endif

#endif
