/* fc_channel.h: packet channels and their faults. Part of fc.h. */
#ifndef FC_CHANNEL_H
#define FC_CHANNEL_H

#include "fc_context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Queue a copy of len bytes for every receiver. FC_OK; FC_E_ARG for data NULL with len > 0;
 * FC_E_NOMEM. */
FC_API int fc_channel_put(fc_context *ctx, const char *channel, const void *data, size_t len);

/* Take the next packet of a receiver ("" or NULL: the one of a channel without subscriptions).
 *   1              delivered: bytes in data, length in *len (len may be NULL)
 *   0              nothing to deliver; data and *len untouched
 *   FC_E_SPACE     capacity is too small: the length needed is in *len, data untouched, packet and
 *                  triggers as before
 *   FC_E_ARG       data is NULL and capacity > 0
 *   FC_E_RECEIVER  that receiver is not subscribed
 *   FC_E_NOMEM */
FC_API int fc_channel_get(fc_context *ctx, const char *channel, const char *receiver, void *data,
                          size_t capacity, size_t *len);

/* Give a receiver a queue of its own: it gets every packet put from now on. From the first
 * subscription on, the receiver "" gets no more packets unless it is subscribed too. FC_OK, also
 * when subscribed already; FC_E_NOMEM. */
FC_API int fc_channel_subscribe(fc_context *ctx, const char *channel, const char *receiver);

/* Discard all queued packets of all receivers. */
FC_API void fc_channel_clear(fc_context *ctx, const char *channel);

/* Packets queued for a receiver; 0 for an unknown channel; FC_E_RECEIVER. */
FC_API int64_t fc_channel_depth(fc_context *ctx, const char *channel, const char *receiver);

/* Flip one bit of each affected packet. FC_E_INDEX if byte < 0, FC_E_BIT if bit is not 0..7. */
FC_API fc_fault_id fc_channel_add_corruption(fc_context *ctx, const char *channel, int byte,
                                             int bit);
/* Discard that many packets, or deliver one packet that many more times: a budget for the life of
 * the fault, for each receiver. FC_E_ARG if < 0. */
FC_API fc_fault_id fc_channel_add_drop(fc_context *ctx, const char *channel, int64_t packets);
FC_API fc_fault_id fc_channel_add_repeat(fc_context *ctx, const char *channel, int64_t packets);

/* The fault added last to the channel, or FC_E_NO_FAULT if there is none or it was refused. */
FC_API fc_fault_id fc_channel_latest(fc_context *ctx, const char *channel);

/* Disarm one channel, or all. Queued packets stay. */
FC_API void fc_channel_remove_faults(fc_context *ctx, const char *channel);
FC_API void fc_channel_remove_all_faults(fc_context *ctx);

#ifdef __cplusplus
}
#endif

#endif
