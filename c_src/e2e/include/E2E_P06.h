/* E2E_P06.h: profile 6. 5-byte header: CRC16 (high byte first), Length, Counter; up to 4096
 * bytes of data; implicit 16-bit Data ID. */
#ifndef E2E_P06_H
#define E2E_P06_H

#include "E2E.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What sender and receiver have agreed on. */
typedef struct {
    uint16 Offset;         /* of the header, bits, multiple of 8 */
    uint16 MinDataLength;  /* bits */
    uint16 MaxDataLength;  /* bits, at most 32768 */
    uint16 DataID;         /* known to both sides */
    uint8 MaxDeltaCounter; /* largest accepted step of the counter */
} E2E_P06ConfigType;

/* The sender's state: one for each stream of packets. */
typedef struct {
    uint8 Counter; /* of the next packet */
} E2E_P06ProtectStateType;

/* The verdict on a packet. */
typedef enum {
    E2E_P06STATUS_OK = 0x00,           /* intact, and the next one */
    E2E_P06STATUS_NONEWDATA = 0x01,    /* nothing has come since the check before */
    E2E_P06STATUS_ERROR = 0x07,        /* corrupted, or not of this sender */
    E2E_P06STATUS_REPEATED = 0x08,     /* the counter of the packet before */
    E2E_P06STATUS_OKSOMELOST = 0x20,   /* intact; some were lost before it, not too many */
    E2E_P06STATUS_WRONGSEQUENCE = 0x40 /* intact; too many were lost before it */
} E2E_P06CheckStatusType;

/* The receiver's state: one for each stream of packets. */
typedef struct {
    E2E_P06CheckStatusType Status; /* of the last check */
    uint8 Counter;                 /* received last */
} E2E_P06CheckStateType;

/* Say whether a configuration is one the standard describes: Offset a multiple of 8,
 * MinDataLength 40..32768, MaxDataLength from there to 32768, header inside MaxDataLength,
 * MaxDeltaCounter not 0. Protect and Check do not ask.
 * Returns E2E_E_OK, E2E_E_INPUTERR_NULL or E2E_E_INPUTERR_WRONG. */
E2E_API Std_ReturnType E2E_P06CheckConfig(const E2E_P06ConfigType *Config);

/* Set Counter to 0. Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P06ProtectInit(E2E_P06ProtectStateType *State);

/* Write Length, Counter and CRC into Data and step the counter.
 *   Length  bytes in Data, header included
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL; E2E_E_INPUTERR_WRONG when 8 * Length is outside
 * MinDataLength..MaxDataLength or ends before the header does: then nothing is changed. */
E2E_API Std_ReturnType E2E_P06Protect(const E2E_P06ConfigType *Config,
                                      E2E_P06ProtectStateType *State, uint8 *Data, uint16 Length);

/* Status ERROR, Counter 0xFF: a sender that starts anew is in sequence. Returns E2E_E_OK or
 * E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P06CheckInit(E2E_P06CheckStateType *State);

/* Check one packet; the verdict is State->Status. ERROR: CRC or Length of the packet is wrong.
 *   Data, Length  the packet as received; NULL and 0 when there is none
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL when Config or State is NULL; E2E_E_INPUTERR_WRONG when
 * one of Data and Length says there is a packet and the other not, or 8 * Length is outside
 * MinDataLength..MaxDataLength or ends before the header does: then nothing is changed. */
E2E_API Std_ReturnType E2E_P06Check(const E2E_P06ConfigType *Config, E2E_P06CheckStateType *State,
                                    const uint8 *Data, uint16 Length);

/* Translate return value and Status of a check for the state machine. */
E2E_API E2E_PCheckStatusType E2E_P06MapStatusToSM(Std_ReturnType CheckReturn,
                                                  E2E_P06CheckStatusType Status);

#ifdef __cplusplus
}
#endif

#endif
