/* E2E_P01.h: profile 1. CRC8 and a 4-bit counter anywhere in at most 240 bits; implicit 16-bit Data
 * ID.
 *
 * Use a Data ID other than 0: the CRC is a plain remainder, so with ID 0 an all-zero packet is
 * valid. */
#ifndef E2E_P01_H
#define E2E_P01_H

#include "E2E.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which bytes of the Data ID enter the CRC. */
typedef enum {
    E2E_P01_DATAID_BOTH = 0,  /* low byte, high byte */
    E2E_P01_DATAID_ALT = 1,   /* even counter: low byte; odd: high byte */
    E2E_P01_DATAID_LOW = 2,   /* low byte only; the high byte must be 0 */
    E2E_P01_DATAID_NIBBLE = 3 /* low byte, 0; bits 8..11 are sent in the packet */
} E2E_P01DataIDMode;

/* Offsets in bits: o addresses byte o / 8, low nibble when o % 8 is 0, high nibble when it is 4. */
/* What sender and receiver have agreed on. */
typedef struct {
    uint16 CounterOffset;         /* multiple of 4 */
    uint16 CRCOffset;             /* multiple of 8 */
    uint16 DataID;                /* see DataIDMode for its limits */
    uint16 DataIDNibbleOffset;    /* multiple of 4; NIBBLE mode only */
    E2E_P01DataIDMode DataIDMode; /* which bytes of it enter the CRC */
    uint16 DataLength;            /* bits, multiple of 8; what the CRC covers */
    uint8 MaxDeltaCounterInit;    /* largest accepted step of the counter after valid data, 0..14 */
    uint8 MaxNoNewOrRepeatedData; /* 0..14; more checks without new data demand a new SYNC */
    uint8 SyncCounterInit;        /* valid packets needed to leave SYNC, 0..14 */
} E2E_P01ConfigType;

/* The sender's state: one for each stream of packets. */
typedef struct {
    uint8 Counter; /* of the next packet, 0..14 */
} E2E_P01ProtectStateType;

/* The verdict on a packet. */
typedef enum {
    E2E_P01STATUS_OK = 0x00,           /* intact, and the next one */
    E2E_P01STATUS_NONEWDATA = 0x01,    /* nothing has come since the check before */
    E2E_P01STATUS_WRONGCRC = 0x02,     /* corrupted */
    E2E_P01STATUS_SYNC = 0x03,         /* intact, but not trusted yet after a jump or a silence */
    E2E_P01STATUS_INITIAL = 0x04,      /* intact, and the first one */
    E2E_P01STATUS_REPEATED = 0x08,     /* the counter of the packet before */
    E2E_P01STATUS_OKSOMELOST = 0x20,   /* intact; some were lost before it, not too many */
    E2E_P01STATUS_WRONGSEQUENCE = 0x40 /* intact; too many were lost before it */
} E2E_P01CheckStatusType;

/* The receiver's state: one for each stream of packets. */
typedef struct {
    uint8 LastValidCounter;           /* of the last valid packet */
    uint8 MaxDeltaCounter;            /* accepted now; grows by one with each check */
    boolean WaitForFirstData;         /* until the first valid packet */
    boolean NewDataAvailable;         /* set by the caller before each check */
    uint8 LostData;                   /* packets missed; meaningful with OK and OKSOMELOST only */
    E2E_P01CheckStatusType Status;    /* of the last check */
    uint8 SyncCounter;                /* valid packets still needed to leave SYNC */
    uint8 NoNewOrRepeatedDataCounter; /* checks without new data or with old */
} E2E_P01CheckStateType;

/* Say whether a configuration is one the standard describes: offsets aligned, DataLength 16..240,
 * CRC byte, counter and ID nibble inside it and apart, limits of the Data ID kept, counters at
 * most 14. Protect and Check do not ask: odd configurations run as they are. Returns E2E_E_OK,
 * E2E_E_INPUTERR_NULL or E2E_E_INPUTERR_WRONG. */
E2E_API Std_ReturnType E2E_P01CheckConfig(const E2E_P01ConfigType *Config);

/* Set Counter to 0. Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P01ProtectInit(E2E_P01ProtectStateType *State);

/* Write counter, ID nibble (NIBBLE mode) and CRC into Data and step the counter.
 *   Data  reaches to the end of DataLength and to the last byte an offset addresses
 * Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P01Protect(const E2E_P01ConfigType *Config,
                                      E2E_P01ProtectStateType *State, uint8 *Data);

/* Wait for first data, Status NONEWDATA, all else 0. Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P01CheckInit(E2E_P01CheckStateType *State);

/* Check one packet; the verdict is State->Status.
 *   Data  as for Protect; not NULL even when NewDataAvailable is FALSE
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL; E2E_E_INPUTERR_WRONG when the counter received is 15,
 * which is never sent: then Status still holds the verdict of an earlier call. */
E2E_API Std_ReturnType E2E_P01Check(const E2E_P01ConfigType *Config, E2E_P01CheckStateType *State,
                                    const uint8 *Data);

/* Translate return value and Status of a check for the state machine.
 *   profileBehavior  TRUE: as profile 4 and later, SYNC counts as OK and INITIAL as WRONGSEQUENCE;
 *                    FALSE: as before R4.2, the other way round */
E2E_API E2E_PCheckStatusType E2E_P01MapStatusToSM(Std_ReturnType CheckReturn,
                                                  E2E_P01CheckStatusType Status,
                                                  boolean profileBehavior);

#ifdef __cplusplus
}
#endif

#endif
