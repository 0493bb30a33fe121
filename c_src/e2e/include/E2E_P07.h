/* E2E_P07.h: profile 7. 20-byte header: CRC64, Length, Counter, Data ID; for large data. */
#ifndef E2E_P07_H
#define E2E_P07_H

#include "E2E.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What sender and receiver have agreed on. */
typedef struct {
    uint32 DataID;          /* known to both sides */
    uint32 Offset;          /* of the header, bits, multiple of 8 */
    uint32 MinDataLength;   /* bits */
    uint32 MaxDataLength;   /* bits */
    uint32 MaxDeltaCounter; /* largest accepted step of the counter */
} E2E_P07ConfigType;

/* The sender's state: one for each stream of packets. */
typedef struct {
    uint32 Counter; /* of the next packet */
} E2E_P07ProtectStateType;

/* The verdict on a packet. */
typedef enum {
    E2E_P07STATUS_OK = 0x00,           /* intact, and the next one */
    E2E_P07STATUS_NONEWDATA = 0x01,    /* nothing has come since the check before */
    E2E_P07STATUS_ERROR = 0x07,        /* corrupted, or not of this sender */
    E2E_P07STATUS_REPEATED = 0x08,     /* the counter of the packet before */
    E2E_P07STATUS_OKSOMELOST = 0x20,   /* intact; some were lost before it, not too many */
    E2E_P07STATUS_WRONGSEQUENCE = 0x40 /* intact; too many were lost before it */
} E2E_P07CheckStatusType;

/* The receiver's state: one for each stream of packets. */
typedef struct {
    E2E_P07CheckStatusType Status; /* of the last check */
    uint32 Counter;                /* received last */
} E2E_P07CheckStateType;

/* Say whether a configuration is one the standard describes: Offset a multiple of 8,
 * MinDataLength at least 160, MaxDataLength not below it, header inside MaxDataLength,
 * MaxDeltaCounter not 0. Protect and Check do not ask.
 * Returns E2E_E_OK, E2E_E_INPUTERR_NULL or E2E_E_INPUTERR_WRONG. */
E2E_API Std_ReturnType E2E_P07CheckConfig(const E2E_P07ConfigType *Config);

/* Set Counter to 0. Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P07ProtectInit(E2E_P07ProtectStateType *State);

/* Write Length, Counter, Data ID and CRC into Data and step the counter.
 *   Length  bytes in Data, header included
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL; E2E_E_INPUTERR_WRONG when 8 * Length is outside
 * MinDataLength..MaxDataLength or ends before the header does: then nothing is changed. */
E2E_API Std_ReturnType E2E_P07Protect(const E2E_P07ConfigType *Config,
                                      E2E_P07ProtectStateType *State, uint8 *Data, uint32 Length);

/* Status ERROR, Counter 0xFFFFFFFF: a sender that starts anew is in sequence. Returns E2E_E_OK
 * or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P07CheckInit(E2E_P07CheckStateType *State);

/* Check one packet; the verdict is State->Status. ERROR: CRC, Data ID or Length of the packet is
 * wrong.
 *   Data, Length  the packet as received; NULL and 0 when there is none
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL when Config or State is NULL; E2E_E_INPUTERR_WRONG when
 * one of Data and Length says there is a packet and the other not, or 8 * Length is outside
 * MinDataLength..MaxDataLength or ends before the header does: then nothing is changed. */
E2E_API Std_ReturnType E2E_P07Check(const E2E_P07ConfigType *Config, E2E_P07CheckStateType *State,
                                    const uint8 *Data, uint32 Length);

/* Translate return value and Status of a check for the state machine. */
E2E_API E2E_PCheckStatusType E2E_P07MapStatusToSM(Std_ReturnType CheckReturn,
                                                  E2E_P07CheckStatusType Status);

#ifdef __cplusplus
}
#endif

#endif
