/* E2E_P04.h: profile 4. 12-byte header: Length, Counter, Data ID, CRC32P4; up to 4096 bytes of
 * data. */
#ifndef E2E_P04_H
#define E2E_P04_H

#include "E2E.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What sender and receiver have agreed on. */
typedef struct {
    uint32 DataID;          /* known to both sides */
    uint16 Offset;          /* of the header, bits, multiple of 8 */
    uint16 MinDataLength;   /* bits */
    uint16 MaxDataLength;   /* bits, at most 32768 */
    uint16 MaxDeltaCounter; /* largest accepted step of the counter */
} E2E_P04ConfigType;

/* The sender's state: one for each stream of packets. */
typedef struct {
    uint16 Counter; /* of the next packet */
} E2E_P04ProtectStateType;

/* The verdict on a packet. */
typedef enum {
    E2E_P04STATUS_OK = 0x00,           /* intact, and the next one */
    E2E_P04STATUS_NONEWDATA = 0x01,    /* nothing has come since the check before */
    E2E_P04STATUS_ERROR = 0x07,        /* corrupted, or not of this sender */
    E2E_P04STATUS_REPEATED = 0x08,     /* the counter of the packet before */
    E2E_P04STATUS_OKSOMELOST = 0x20,   /* intact; some were lost before it, not too many */
    E2E_P04STATUS_WRONGSEQUENCE = 0x40 /* intact; too many were lost before it */
} E2E_P04CheckStatusType;

/* The receiver's state: one for each stream of packets. */
typedef struct {
    E2E_P04CheckStatusType Status; /* of the last check */
    uint16 Counter;                /* received last */
} E2E_P04CheckStateType;

/* Say whether a configuration is one the standard describes: Offset a multiple of 8,
 * MinDataLength 96..32768, MaxDataLength from there to 32768, header inside MaxDataLength,
 * MaxDeltaCounter not 0. Protect and Check do not ask.
 * Returns E2E_E_OK, E2E_E_INPUTERR_NULL or E2E_E_INPUTERR_WRONG. */
E2E_API Std_ReturnType E2E_P04CheckConfig(const E2E_P04ConfigType *Config);

/* Set Counter to 0. Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P04ProtectInit(E2E_P04ProtectStateType *State);

/* Write Length, Counter, Data ID and CRC into Data and step the counter.
 *   Length  bytes in Data, header included
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL; E2E_E_INPUTERR_WRONG when 8 * Length is outside
 * MinDataLength..MaxDataLength or ends before the header does: then nothing is changed. */
E2E_API Std_ReturnType E2E_P04Protect(const E2E_P04ConfigType *Config,
                                      E2E_P04ProtectStateType *State, uint8 *Data, uint16 Length);

/* Status ERROR, Counter 0xFFFF: a sender that starts anew is in sequence. Returns E2E_E_OK or
 * E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P04CheckInit(E2E_P04CheckStateType *State);

/* Check one packet; the verdict is State->Status. ERROR: CRC, Data ID or Length of the packet is
 * wrong.
 *   Data, Length  the packet as received; NULL and 0 when there is none
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL when Config or State is NULL; E2E_E_INPUTERR_WRONG when
 * one of Data and Length says there is a packet and the other not, or 8 * Length is outside
 * MinDataLength..MaxDataLength or ends before the header does: then nothing is changed. */
E2E_API Std_ReturnType E2E_P04Check(const E2E_P04ConfigType *Config, E2E_P04CheckStateType *State,
                                    const uint8 *Data, uint16 Length);

/* Translate return value and Status of a check for the state machine. */
E2E_API E2E_PCheckStatusType E2E_P04MapStatusToSM(Std_ReturnType CheckReturn,
                                                  E2E_P04CheckStatusType Status);

#ifdef __cplusplus
}
#endif

#endif
