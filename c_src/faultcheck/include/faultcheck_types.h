/* faultcheck_types.h: the enumerations of the compatible interface. */
#ifndef FAULTCHECK_TYPES_H
#define FAULTCHECK_TYPES_H

/* The faults of probes. */
typedef enum {
    FAULT_NONE = 0,
    FAULT_BITFLIP = 1,
    FAULT_BITFLIP_RANDOM = 2,
    FAULT_STUCK_TO_CURRENT = 3,
    FAULT_AMPLIFICATION = 4,
    FAULT_OFFSET = 5,
    FAULT_SET_TO = 6
} FAULT_TYPE;

/* The triggers of the original. fc_trigger.h offers more. */
typedef enum {
    TRG_PERMANENT = 0,
    TRG_AFTER_ITR = 1,
    TRG_RANDOM = 2,
    TRG_RANDOM_ONCE = 3
} TRIGGER_TYPE;

/* The faults of packet channels. */
typedef enum {
    PACKET_FAULT_NONE = 0,
    PACKET_FAULT_DROP = 1,
    PACKET_FAULT_REPETITION = 2,
    PACKET_FAULT_CURRUPTION = 3, /* the historical spelling */
    PACKET_FAULT_CORRUPTION = PACKET_FAULT_CURRUPTION
} PACKET_FAULT_TYPE;

#endif
