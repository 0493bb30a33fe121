/* E2E.h: what all AUTOSAR end-to-end profiles share: return codes and the profile-independent
 * status.
 *
 * Each profile has a header of its own, E2E_Pxx.h; the state machine is in E2E_SM.h, the checksums
 * in Crc.h.
 *
 * Units      offsets and DataLength, MinDataLength, MaxDataLength in configurations are in bits;
 *            Length arguments are in bytes and count the whole protected data, header included.
 * Ownership  the caller owns everything; the library keeps no pointer, no heap, no variable.
 * Threads    every function may be called from any thread; two must not share one state.
 * Errors     a Check that returns anything but E2E_E_OK leaves Status as it was. */
#ifndef E2E_H
#define E2E_H

#include "E2E_Types.h"

/* The function did its work. Of a Check this says nothing about the data: read Status. */
#define E2E_E_OK ((Std_ReturnType)0x00)
/* A required pointer is NULL. */
#define E2E_E_INPUTERR_NULL ((Std_ReturnType)0x13)
/* An argument is out of its range. */
#define E2E_E_INPUTERR_WRONG ((Std_ReturnType)0x17)
/* The state handed in cannot have come from this library. */
#define E2E_E_INTERR ((Std_ReturnType)0x19)
/* E2E_SMCheck was called in the state DEINIT. */
#define E2E_E_WRONGSTATE ((Std_ReturnType)0x1A)

/* What a profile's status means to the state machine. */
typedef enum {
    E2E_P_OK = 0,
    E2E_P_REPEATED = 1,
    E2E_P_WRONGSEQUENCE = 2,
    E2E_P_ERROR = 3,
    E2E_P_NOTAVAILABLE = 4,
    E2E_P_NONEWDATA = 5
} E2E_PCheckStatusType;

#endif
