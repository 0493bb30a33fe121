/* E2E_P44.h: profile 44. The packet of profile 4 with wider limits: up to 65535 bytes of data. */
#ifndef E2E_P44_H
#define E2E_P44_H

#include "E2E.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What sender and receiver have agreed on. */
typedef struct {
    uint32 DataID;          /* known to both sides */
    uint32 Offset;          /* of the header, bits, multiple of 8 */
    uint32 MinDataLength;   /* bits */
    uint32 MaxDataLength;   /* bits, at most 524280 */
    uint16 MaxDeltaCounter; /* largest accepted step of the counter */
} E2E_P44ConfigType;

/* The sender's state: one for each stream of packets. */
typedef struct {
    uint16 Counter; /* of the next packet */
} E2E_P44ProtectStateType;

/* The verdict on a packet. */
typedef enum {
    E2E_P44STATUS_OK = 0x00,           /* intact, and the next one */
    E2E_P44STATUS_NONEWDATA = 0x01,    /* nothing has come since the check before */
    E2E_P44STATUS_ERROR = 0x07,        /* corrupted, or not of this sender */
    E2E_P44STATUS_REPEATED = 0x08,     /* the counter of the packet before */
    E2E_P44STATUS_OKSOMELOST = 0x20,   /* intact; some were lost before it, not too many */
    E2E_P44STATUS_WRONGSEQUENCE = 0x40 /* intact; too many were lost before it */
} E2E_P44CheckStatusType;

/* The receiver's state: one for each stream of packets. */
typedef struct {
    E2E_P44CheckStatusType Status; /* of the last check */
    uint16 Counter;                /* received last */
} E2E_P44CheckStateType;

/* Say whether a configuration is one the standard describes: Offset a multiple of 8,
 * MinDataLength 96..524280, MaxDataLength from there to 524280, header inside MaxDataLength,
 * MaxDeltaCounter not 0. Protect and Check do not ask.
 * Returns E2E_E_OK, E2E_E_INPUTERR_NULL or E2E_E_INPUTERR_WRONG. */
E2E_API Std_ReturnType E2E_P44CheckConfig(const E2E_P44ConfigType *Config);

/* Set Counter to 0. Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P44ProtectInit(E2E_P44ProtectStateType *State);

/* Write Length, Counter, Data ID and CRC into Data and step the counter.
 *   Length  bytes in Data, header included
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL; E2E_E_INPUTERR_WRONG when 8 * Length is outside
 * MinDataLength..MaxDataLength or ends before the header does: then nothing is changed. */
E2E_API Std_ReturnType E2E_P44Protect(const E2E_P44ConfigType *Config,
                                      E2E_P44ProtectStateType *State, uint8 *Data, uint16 Length);

/* Status ERROR, Counter 0xFFFF: a sender that starts anew is in sequence. Returns E2E_E_OK or
 * E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P44CheckInit(E2E_P44CheckStateType *State);

/* Check one packet; the verdict is State->Status. ERROR: CRC, Data ID or Length of the packet is
 * wrong.
 *   Data, Length  the packet as received; NULL and 0 when there is none
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL when Config or State is NULL; E2E_E_INPUTERR_WRONG when
 * one of Data and Length says there is a packet and the other not, or 8 * Length is outside
 * MinDataLength..MaxDataLength or ends before the header does: then nothing is changed. */
E2E_API Std_ReturnType E2E_P44Check(const E2E_P44ConfigType *Config, E2E_P44CheckStateType *State,
                                    const uint8 *Data, uint16 Length);

/* Translate return value and Status of a check for the state machine. */
E2E_API E2E_PCheckStatusType E2E_P44MapStatusToSM(Std_ReturnType CheckReturn,
                                                  E2E_P44CheckStatusType Status);

#ifdef __cplusplus
}
#endif

#endif
