/* E2E_P05.h: profile 5. 3-byte header: CRC16 (low byte first), Counter; fixed length up to 4096
 * bytes; implicit 16-bit Data ID. */
#ifndef E2E_P05_H
#define E2E_P05_H

#include "E2E.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What sender and receiver have agreed on. */
typedef struct {
    uint16 Offset;         /* of the header, bits, multiple of 8 */
    uint16 DataLength;     /* bits, multiple of 8 */
    uint16 DataID;         /* known to both sides */
    uint8 MaxDeltaCounter; /* largest accepted step of the counter */
} E2E_P05ConfigType;

/* The sender's state: one for each stream of packets. */
typedef struct {
    uint8 Counter; /* of the next packet */
} E2E_P05ProtectStateType;

/* The verdict on a packet. */
typedef enum {
    E2E_P05STATUS_OK = 0x00,           /* intact, and the next one */
    E2E_P05STATUS_NONEWDATA = 0x01,    /* nothing has come since the check before */
    E2E_P05STATUS_ERROR = 0x07,        /* corrupted, or not of this sender */
    E2E_P05STATUS_REPEATED = 0x08,     /* the counter of the packet before */
    E2E_P05STATUS_OKSOMELOST = 0x20,   /* intact; some were lost before it, not too many */
    E2E_P05STATUS_WRONGSEQUENCE = 0x40 /* intact; too many were lost before it */
} E2E_P05CheckStatusType;

/* The receiver's state: one for each stream of packets. */
typedef struct {
    E2E_P05CheckStatusType Status; /* of the last check */
    uint8 Counter;                 /* received last */
} E2E_P05CheckStateType;

/* Say whether a configuration is one the standard describes: Offset and DataLength multiples of
 * 8, DataLength at most 32768, header inside it, MaxDeltaCounter not 0. Protect and Check do not
 * ask.
 * Returns E2E_E_OK, E2E_E_INPUTERR_NULL or E2E_E_INPUTERR_WRONG. */
E2E_API Std_ReturnType E2E_P05CheckConfig(const E2E_P05ConfigType *Config);

/* Set Counter to 0. Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P05ProtectInit(E2E_P05ProtectStateType *State);

/* Write Counter and CRC into Data and step the counter.
 *   Length  bytes in Data, header included
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL; E2E_E_INPUTERR_WRONG when 8 * Length is not DataLength
 * or ends before the header does: then nothing is changed. */
E2E_API Std_ReturnType E2E_P05Protect(const E2E_P05ConfigType *Config,
                                      E2E_P05ProtectStateType *State, uint8 *Data, uint16 Length);

/* Status ERROR, Counter 0xFF: a sender that starts anew is in sequence. Returns E2E_E_OK or
 * E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P05CheckInit(E2E_P05CheckStateType *State);

/* Check one packet; the verdict is State->Status. ERROR: the CRC is wrong.
 *   Data, Length  the packet as received; NULL and 0 when there is none
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL when Config or State is NULL; E2E_E_INPUTERR_WRONG when
 * one of Data and Length says there is a packet and the other not, or 8 * Length is not
 * DataLength or ends before the header does: then nothing is changed. */
E2E_API Std_ReturnType E2E_P05Check(const E2E_P05ConfigType *Config, E2E_P05CheckStateType *State,
                                    const uint8 *Data, uint16 Length);

/* Translate return value and Status of a check for the state machine. */
E2E_API E2E_PCheckStatusType E2E_P05MapStatusToSM(Std_ReturnType CheckReturn,
                                                  E2E_P05CheckStatusType Status);

#ifdef __cplusplus
}
#endif

#endif
