/* E2E_P11.h: profile 11. The packet of profile 1 (CRC8 and 4-bit counter, free places) with the
 * checks of profiles 4 and later; at most 240 bits; use a Data ID other than 0. */
#ifndef E2E_P11_H
#define E2E_P11_H

#include "E2E.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which bytes of the Data ID enter the CRC. */
typedef enum {
    E2E_P11_DATAID_BOTH = 0,  /* low byte, high byte */
    E2E_P11_DATAID_NIBBLE = 3 /* low byte, 0; bits 8..11 are sent in the packet */
} E2E_P11DataIDMode;

/* What sender and receiver have agreed on. */
typedef struct {
    uint16 CounterOffset;         /* bits, multiple of 4 */
    uint16 CRCOffset;             /* bits, multiple of 8 */
    uint16 DataID;                /* NIBBLE mode: at most 0x0FFF */
    uint16 DataIDNibbleOffset;    /* bits, multiple of 4; NIBBLE mode only */
    E2E_P11DataIDMode DataIDMode; /* which bytes of it enter the CRC */
    uint16 DataLength;            /* bits, multiple of 8 */
    uint8 MaxDeltaCounter;        /* largest accepted step of the counter, 1..14 */
} E2E_P11ConfigType;

/* The sender's state: one for each stream of packets. */
typedef struct {
    uint8 Counter; /* of the next packet */
} E2E_P11ProtectStateType;

/* The verdict on a packet. */
typedef enum {
    E2E_P11STATUS_OK = 0x00,           /* intact, and the next one */
    E2E_P11STATUS_NONEWDATA = 0x01,    /* nothing has come since the check before */
    E2E_P11STATUS_ERROR = 0x07,        /* corrupted, or not of this sender */
    E2E_P11STATUS_REPEATED = 0x08,     /* the counter of the packet before */
    E2E_P11STATUS_OKSOMELOST = 0x20,   /* intact; some were lost before it, not too many */
    E2E_P11STATUS_WRONGSEQUENCE = 0x40 /* intact; too many were lost before it */
} E2E_P11CheckStatusType;

/* The receiver's state: one for each stream of packets. */
typedef struct {
    E2E_P11CheckStatusType Status; /* of the last check */
    uint8 Counter;                 /* received last */
} E2E_P11CheckStateType;

/* Say whether a configuration is one the standard describes: offsets aligned, DataLength 16..240
 * and a multiple of 8, CRC byte, counter and ID nibble inside it and apart, the limit of the
 * Data ID in NIBBLE mode kept, MaxDeltaCounter 1..14. Protect and Check do not ask.
 * Returns E2E_E_OK, E2E_E_INPUTERR_NULL or E2E_E_INPUTERR_WRONG. */
E2E_API Std_ReturnType E2E_P11CheckConfig(const E2E_P11ConfigType *Config);

/* Set Counter to 0. Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P11ProtectInit(E2E_P11ProtectStateType *State);

/* Write counter, ID nibble (NIBBLE mode) and CRC into Data and step the counter.
 *   Length  bytes in Data, header included
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL; E2E_E_INPUTERR_WRONG when 8 * Length is not DataLength
 * or the CRC, the counter or the ID nibble would lie outside: then nothing is changed. */
E2E_API Std_ReturnType E2E_P11Protect(const E2E_P11ConfigType *Config,
                                      E2E_P11ProtectStateType *State, uint8 *Data, uint16 Length);

/* Status ERROR, Counter 14: a sender that starts anew is in sequence. Returns E2E_E_OK or
 * E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P11CheckInit(E2E_P11CheckStateType *State);

/* Check one packet; the verdict is State->Status. ERROR: the CRC or the ID nibble is wrong, or
 * the counter is 15, which is never sent.
 *   Data, Length  the packet as received; NULL and 0 when there is none
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL when Config or State is NULL; E2E_E_INPUTERR_WRONG when
 * one of Data and Length says there is a packet and the other not, or 8 * Length is not
 * DataLength or the CRC, the counter or the ID nibble would lie outside: then nothing is
 * changed. */
E2E_API Std_ReturnType E2E_P11Check(const E2E_P11ConfigType *Config, E2E_P11CheckStateType *State,
                                    const uint8 *Data, uint16 Length);

/* Translate return value and Status of a check for the state machine. */
E2E_API E2E_PCheckStatusType E2E_P11MapStatusToSM(Std_ReturnType CheckReturn,
                                                  E2E_P11CheckStatusType Status);

#ifdef __cplusplus
}
#endif

#endif
