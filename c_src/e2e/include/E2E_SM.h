/* E2E_SM.h: the state machine that judges a whole communication from the verdicts on its packets.
 *
 * It keeps the newest verdicts in a window, counts those that are E2E_P_OK and E2E_P_ERROR, and
 * compares the counts with limits that depend on the state it is in.
 *
 * Where releases of the standard differ: the verdict that leaves NODATA is not counted; the window
 * is cleared only on the way to INVALID and only with ClearToInvalid; the counts are those of the
 * newest entries. */
#ifndef E2E_SM_H
#define E2E_SM_H

#include "E2E.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What a communication is worth. */
typedef enum {
    E2E_SM_VALID = 0,  /* use the data */
    E2E_SM_DEINIT = 1, /* not initialised */
    E2E_SM_NODATA = 2, /* nothing usable received yet */
    E2E_SM_INIT = 3,   /* packets come, not enough to judge */
    E2E_SM_INVALID = 4 /* do not use the data */
} E2E_SMStateType;

/* For each state: how many of the newest verdicts count, and the limits on them. */
typedef struct {
    uint8 WindowSizeValid;      /* at least 1, and not below the other two */
    uint8 WindowSizeInit;       /* in INIT */
    uint8 WindowSizeInvalid;    /* in INVALID */
    uint8 MinOkStateInit;       /* E2E_P_OK needed to go from INIT to VALID */
    uint8 MaxErrorStateInit;    /* E2E_P_ERROR allowed in INIT */
    uint8 MinOkStateValid;      /* needed to stay in VALID */
    uint8 MaxErrorStateValid;   /* allowed in VALID */
    uint8 MinOkStateInvalid;    /* needed to go from INVALID to VALID */
    uint8 MaxErrorStateInvalid; /* allowed on that way */
    boolean ClearToInvalid;     /* forget all verdicts on the way to INVALID */
} E2E_SMConfigType;

/* One for each communication. */
typedef struct {
    uint8 *ProfileStatusWindow; /* the caller's, WindowSizeValid entries */
    uint8 WindowTopIndex;       /* where the next verdict goes */
    uint8 OkCount;              /* E2E_P_OK among those that count */
    uint8 ErrorCount;           /* E2E_P_ERROR among them */
    E2E_SMStateType SMState;    /* the result */
} E2E_SMCheckStateType;

/* Say whether a configuration is one the standard describes: WindowSizeValid at least 1 and the
 * largest; MaxErrorStateValid >= MaxErrorStateInit >= MaxErrorStateInvalid; 1 <= MinOkStateValid <=
 * MinOkStateInit <= MinOkStateInvalid; in each state MinOk + MaxError at most the window.
 * The other functions ask only that WindowSizeValid is not 0.
 * Returns E2E_E_OK, E2E_E_INPUTERR_NULL or E2E_E_INPUTERR_WRONG. */
E2E_API Std_ReturnType E2E_SMCheckConfig(const E2E_SMConfigType *ConfigPtr);

/* Empty the window and go to NODATA; ProfileStatusWindow must be set already.
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL when an argument or the window is NULL;
 * E2E_E_INPUTERR_WRONG when WindowSizeValid is 0. */
E2E_API Std_ReturnType E2E_SMCheckInit(E2E_SMCheckStateType *StatePtr,
                                       const E2E_SMConfigType *ConfigPtr);

/* Take one verdict into account; the result is StatePtr->SMState.
 * Returns E2E_E_OK; E2E_E_INPUTERR_NULL when an argument or the window is NULL; E2E_E_WRONGSTATE in
 * the state DEINIT; E2E_E_INPUTERR_WRONG when ProfileStatus is none or WindowSizeValid is 0;
 * E2E_E_INTERR when SMState or WindowTopIndex has a value this library never leaves there. Nothing
 * changes then. */
E2E_API Std_ReturnType E2E_SMCheck(E2E_PCheckStatusType ProfileStatus,
                                   const E2E_SMConfigType *ConfigPtr,
                                   E2E_SMCheckStateType *StatePtr);

#ifdef __cplusplus
}
#endif

#endif
