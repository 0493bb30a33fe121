/* E2E_P02.h: profile 2. CRC8H2F in byte 0, 4-bit counter in the low nibble of byte 1; fixed length;
 * a Data ID for each counter value. */
#ifndef E2E_P02_H
#define E2E_P02_H

#include "E2E.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What sender and receiver have agreed on. */
typedef struct {
    uint16 DataLength;            /* bits, multiple of 8, 16..2048 */
    uint8 DataIDList[16];         /* the Data ID that goes with each counter value */
    uint8 MaxDeltaCounterInit;    /* largest accepted step of the counter after valid data, 0..15 */
    uint8 MaxNoNewOrRepeatedData; /* 0..15; more checks without new data demand a new SYNC */
    uint8 SyncCounterInit;        /* valid packets needed to leave SYNC, 0..15 */
    uint16 Offset;                /* of the header, bits, multiple of 8; not 0: as profile 22 */
} E2E_P02ConfigType;

/* The sender's state: one for each stream of packets. */
typedef struct {
    uint8 Counter; /* of the packet sent last, 0..15; the next one carries one more */
} E2E_P02ProtectStateType;

/* The verdict on a packet. */
typedef enum {
    E2E_P02STATUS_OK = 0x00,           /* intact, and the next one */
    E2E_P02STATUS_NONEWDATA = 0x01,    /* nothing has come since the check before */
    E2E_P02STATUS_WRONGCRC = 0x02,     /* corrupted */
    E2E_P02STATUS_SYNC = 0x03,         /* intact, but not trusted yet after a jump or a silence */
    E2E_P02STATUS_INITIAL = 0x04,      /* intact, and the first one */
    E2E_P02STATUS_REPEATED = 0x08,     /* the counter of the packet before */
    E2E_P02STATUS_OKSOMELOST = 0x20,   /* intact; some were lost before it, not too many */
    E2E_P02STATUS_WRONGSEQUENCE = 0x40 /* intact; too many were lost before it */
} E2E_P02CheckStatusType;

/* The receiver's state: one for each stream of packets. */
typedef struct {
    uint8 LastValidCounter;           /* of the last valid packet */
    uint8 MaxDeltaCounter;            /* accepted now; grows by one with each check */
    boolean WaitForFirstData;         /* until the first valid packet */
    boolean NewDataAvailable;         /* set by the caller before each check */
    uint8 LostData;                   /* packets missed; meaningful with OK and OKSOMELOST only */
    E2E_P02CheckStatusType Status;    /* of the last check */
    uint8 SyncCounter;                /* valid packets still needed to leave SYNC */
    uint8 NoNewOrRepeatedDataCounter; /* checks without new data or with old */
} E2E_P02CheckStateType;

/* Say whether a configuration is one the standard describes: DataLength and Offset multiples of 8,
 * DataLength at most 2048, header inside it, counters at most 15. Protect and Check ask only that
 * the header lies inside DataLength.
 * Returns E2E_E_OK, E2E_E_INPUTERR_NULL or E2E_E_INPUTERR_WRONG. */
E2E_API Std_ReturnType E2E_P02CheckConfig(const E2E_P02ConfigType *Config);

/* Set Counter to 0. Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P02ProtectInit(E2E_P02ProtectStateType *State);

/* Step the counter, write counter and CRC into Data.
 *   Data  DataLength / 8 bytes
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL; E2E_E_INPUTERR_WRONG when the header would lie outside
 * DataLength: then nothing is changed. */
E2E_API Std_ReturnType E2E_P02Protect(const E2E_P02ConfigType *Config,
                                      E2E_P02ProtectStateType *State, uint8 *Data);

/* Wait for first data, Status NONEWDATA, all else 0. Returns E2E_E_OK or E2E_E_INPUTERR_NULL. */
E2E_API Std_ReturnType E2E_P02CheckInit(E2E_P02CheckStateType *State);

/* Check one packet; the verdict is State->Status.
 *   Data  DataLength / 8 bytes; not NULL even when NewDataAvailable is FALSE
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL; E2E_E_INPUTERR_WRONG when the header would lie outside
 * DataLength: then nothing is changed. */
E2E_API Std_ReturnType E2E_P02Check(const E2E_P02ConfigType *Config, E2E_P02CheckStateType *State,
                                    const uint8 *Data);

/* Translate return value and Status of a check for the state machine.
 *   profileBehavior  TRUE: as profile 4 and later, SYNC counts as OK and INITIAL as WRONGSEQUENCE;
 *                    FALSE: as before R4.2, the other way round */
E2E_API E2E_PCheckStatusType E2E_P02MapStatusToSM(Std_ReturnType CheckReturn,
                                                  E2E_P02CheckStatusType Status,
                                                  boolean profileBehavior);

#ifdef __cplusplus
}
#endif

#endif
