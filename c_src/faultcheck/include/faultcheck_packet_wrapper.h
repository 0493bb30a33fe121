/* faultcheck_packet_wrapper.h: packet channels and their faults, source compatible with the fault
 * injector of the thesis.
 *
 * Everything here acts on the default context of fc.h. Channels have a name space of their own. One
 * iteration of a trigger is one faultcheck_packet_getPacket on an existing channel, also when the
 * channel is empty. */
#ifndef FAULTCHECK_PACKET_WRAPPER_H
#define FAULTCHECK_PACKET_WRAPPER_H

#include "faultcheck_types.h"
#include "fc_export.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Queue a copy of len bytes (0 allowed). */
FC_API void faultcheck_packet_addPacket(const char *identifier, const char *data, int len);

/* Take the next packet. 1: its bytes are in data, its length in *len (len may be NULL); 0: nothing
 * was written. The caller must know that data is large enough; fc_channel_get takes a capacity. */
FC_API int faultcheck_packet_getPacket(const char *identifier, char *data, int *len);

/* Flip bit 0..7 of one byte of each affected packet. */
FC_API void faultcheck_packet_addFaultCorruptionBitFlip(const char *identifier, int byteIndex,
                                                        int bitToFlip);

/* Discard numPackets packets, or deliver one packet numPackets more times; a budget for the life of
 * the fault. */
FC_API void faultcheck_packet_addFaultDrop(const char *identifier, int numPackets);
FC_API void faultcheck_packet_addFaultRepeat(const char *identifier, int numPackets);

/* As in faultcheck_wrapper.h: these act on the fault added last to the channel. */
FC_API void faultcheck_packet_setTriggerOnceAfterIterations(const char *identifier,
                                                            unsigned long iterations);
FC_API void faultcheck_packet_setTriggerAfterIterations(const char *identifier,
                                                        unsigned long iterations);
FC_API void faultcheck_packet_setDurationAfterTrigger(const char *identifier, int iterations);

/* Disarm one channel, or all. Queued packets stay. */
FC_API void faultcheck_packet_removeAllFaultsIdentifier(const char *identifier);
FC_API void faultcheck_packet_removeAllFaults(void);

#ifdef __cplusplus
}
#endif

#endif
