/* fc_channel.h: packet channels and their faults. Part of fc.h. */
#ifndef FC_CHANNEL_H
#define FC_CHANNEL_H

#include "fc_context.h"
#include "fc_fault.h"
#include "fc_probe.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Queue a copy of len bytes for every receiver. FC_OK; FC_E_ARG for data NULL with len > 0;
 * FC_E_BLOCKED; FC_E_NOMEM. */
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

/* ---- faults met at each get: a fault id, or FC_E_NOMEM, or what is said ----
 *
 * They are walked in the order of adding, for each receiver with its own trigger state. Those that
 * alter work on the current packet; the clean packet is the current one before any alteration.
 * INSERT, MASQUERADE, RESEQUENCE and REPEAT_LAST choose the current and clean packet for the
 * faults that follow; what had been taken from the queue goes back to its head. */

/* Flip one bit. FC_E_INDEX if byte < 0, FC_E_BIT if bit is not 0..7. A packet without that byte is
 * delivered as it is (FC_E_INDEX). */
FC_API fc_fault_id fc_channel_add_corruption(fc_context *ctx, const char *channel, int byte,
                                             int bit);

/* A typed field of a packet. */
typedef struct {
    size_t offset;   /* of its first byte */
    fc_type type;    /* any, FC_BYTES too */
    bool big_endian; /* byte order; FC_BYTES has none */
    size_t length;   /* of FC_BYTES; 0: up to the end of the packet */
} fc_field;

/* Any model on a field. FC_E_ARG for a NULL or unknown type, and as fc_add_model. */
FC_API fc_fault_id fc_channel_add_field(fc_context *ctx, const char *channel, const fc_field *field,
                                        const fc_model *model);

/* Cut to at most `bytes`, append `count` times `byte`. FC_E_ARG from 2^63 on. */
FC_API fc_fault_id fc_channel_add_truncate(fc_context *ctx, const char *channel, size_t bytes);
FC_API fc_fault_id fc_channel_add_extend(fc_context *ctx, const char *channel, size_t count,
                                         unsigned char byte);

/* Discard that many packets, or deliver one packet that many more times: a budget for the life of
 * the fault, for each receiver. FC_E_ARG if < 0. */
FC_API fc_fault_id fc_channel_add_drop(fc_context *ctx, const char *channel, int64_t packets);
FC_API fc_fault_id fc_channel_add_repeat(fc_context *ctx, const char *channel, int64_t packets);

/* Each affected get discards one packet and goes on with the next. */
FC_API fc_fault_id fc_channel_add_lose(fc_context *ctx, const char *channel);

/* The packet delivered before is delivered again, the head stays; none before: no effect. */
FC_API fc_fault_id fc_channel_add_repeat_last(fc_context *ctx, const char *channel);

/* Up to `times` times the given packet is delivered while the head stays, also on an empty
 * channel. FC_E_ARG if times < 0 or data NULL with len > 0. */
FC_API fc_fault_id fc_channel_add_insert(fc_context *ctx, const char *channel, const void *data,
                                         size_t len, int64_t times);

/* The head of channel `from` is taken (that of the receiver of the same name, otherwise of "") and
 * delivered as if it belonged here; nothing there: no effect. */
FC_API fc_fault_id fc_channel_add_masquerade(fc_context *ctx, const char *channel,
                                             const char *from);

/* The packet at that position (0: the head) instead of the head; the last one if fewer are queued.
 * FC_E_ARG if < 0. */
FC_API fc_fault_id fc_channel_add_resequence(fc_context *ctx, const char *channel,
                                             int64_t position);

/* Nothing is delivered, the queue is untouched. */
FC_API fc_fault_id fc_channel_add_block_get(fc_context *ctx, const char *channel);

/* Only for one receiver from now on. FC_OK, FC_E_NO_FAULT; FC_E_ARG for a fault that is not met at
 * a get. */
FC_API int fc_channel_fault_receiver(fc_context *ctx, fc_fault_id fault, const char *receiver);

/* ---- faults met at each put: a fault id, or FC_E_NOMEM, or what is said ---- */

/* The packet is hidden from a receiver during his next `gets` gets, or for that time. Order is
 * kept: a hidden head blocks the packets behind it. FC_E_ARG if < 0. */
FC_API fc_fault_id fc_channel_add_delay(fc_context *ctx, const char *channel, int64_t gets);
FC_API fc_fault_id fc_channel_add_delay_time(fc_context *ctx, const char *channel, int64_t ns);

/* The packet goes to the receivers of channel `to` and not to its own. */
FC_API fc_fault_id fc_channel_add_misroute(fc_context *ctx, const char *channel, const char *to);

/* The listed receivers get a copy altered by the model, the others the original. field NULL: the
 * whole packet as bytes. FC_E_ARG for receivers NULL, and as fc_channel_add_field. */
FC_API fc_fault_id fc_channel_add_asymmetric(fc_context *ctx, const char *channel,
                                             const char *const *receivers, size_t count,
                                             const fc_field *field, const fc_model *model);

/* Only the listed receivers get the packet. FC_E_ARG for receivers NULL. */
FC_API fc_fault_id fc_channel_add_subset(fc_context *ctx, const char *channel,
                                         const char *const *receivers, size_t count);

/* The packet is refused: the put returns FC_E_BLOCKED. */
FC_API fc_fault_id fc_channel_add_block_put(fc_context *ctx, const char *channel);

/* The fault added last to the channel, or FC_E_NO_FAULT if there is none or it was refused. */
FC_API fc_fault_id fc_channel_latest(fc_context *ctx, const char *channel);

/* Disarm one channel, or all. Queued packets stay. */
FC_API void fc_channel_remove_faults(fc_context *ctx, const char *channel);
FC_API void fc_channel_remove_all_faults(fc_context *ctx);

#ifdef __cplusplus
}
#endif

#endif
