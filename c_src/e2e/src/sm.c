/* The E2E state machine (e2e.md section 8). */
#include "E2E_SM.h"

/* The verdicts that count in each state; never more than the window holds. */
static uint8 window_size(const E2E_SMConfigType *config, E2E_SMStateType state) {
    uint8 size = config->WindowSizeValid;
    if (state == E2E_SM_INIT) {
        size = config->WindowSizeInit;
    } else if (state == E2E_SM_INVALID) {
        size = config->WindowSizeInvalid;
    }
    return size < config->WindowSizeValid ? size : config->WindowSizeValid;
}

/* Where the verdict `age` places before the next one lies; age 1 is the newest. */
static uint32 index_of(const E2E_SMConfigType *config, const E2E_SMCheckStateType *state,
                       uint32 age) {
    return (state->WindowTopIndex + (uint32)config->WindowSizeValid - age) %
           config->WindowSizeValid;
}

static void clear(const E2E_SMConfigType *config, E2E_SMCheckStateType *state) {
    for (uint32 i = 0; i < config->WindowSizeValid; i++) {
        state->ProfileStatusWindow[i] = E2E_P_NOTAVAILABLE;
    }
    state->WindowTopIndex = 0;
    state->OkCount = 0;
    state->ErrorCount = 0;
}

/* Before a state with a larger window: the verdicts it would look at, and this state did not, are
 * forgotten. */
static void clear_remaining(const E2E_SMConfigType *config, E2E_SMCheckStateType *state,
                            E2E_SMStateType next) {
    const uint32 size = window_size(config, state->SMState);
    if (size < window_size(config, next)) {
        for (uint32 age = size + 1U; age <= config->WindowSizeValid; age++) {
            state->ProfileStatusWindow[index_of(config, state, age)] = E2E_P_NOTAVAILABLE;
        }
    }
}

static void add(const E2E_SMConfigType *config, E2E_SMCheckStateType *state,
                E2E_PCheckStatusType status) {
    const uint32 size = window_size(config, state->SMState);
    state->ProfileStatusWindow[state->WindowTopIndex] = (uint8)status;
    state->WindowTopIndex = (uint8)((state->WindowTopIndex + 1U) % config->WindowSizeValid);
    state->OkCount = 0;
    state->ErrorCount = 0;
    for (uint32 age = 1; age <= size; age++) {
        const uint8 entry = state->ProfileStatusWindow[index_of(config, state, age)];
        state->OkCount = (uint8)(state->OkCount + (entry == E2E_P_OK));
        state->ErrorCount = (uint8)(state->ErrorCount + (entry == E2E_P_ERROR));
    }
}

static void become_valid(const E2E_SMConfigType *config, E2E_SMCheckStateType *state) {
    clear_remaining(config, state, E2E_SM_VALID);
    state->SMState = E2E_SM_VALID;
}

static void become_invalid(const E2E_SMConfigType *config, E2E_SMCheckStateType *state) {
    if (config->ClearToInvalid) {
        clear(config, state);
    } else {
        clear_remaining(config, state, E2E_SM_INVALID);
    }
    state->SMState = E2E_SM_INVALID;
}

static int within(const E2E_SMCheckStateType *state, uint8 max_error, uint8 min_ok) {
    return state->ErrorCount <= max_error && state->OkCount >= min_ok;
}

static void step_nodata(const E2E_SMConfigType *config, E2E_SMCheckStateType *state,
                        E2E_PCheckStatusType status) {
    if (status != E2E_P_ERROR && status != E2E_P_NONEWDATA) {
        clear(config, state);
        state->SMState = E2E_SM_INIT;
    }
}

static void step_init(const E2E_SMConfigType *config, E2E_SMCheckStateType *state,
                      E2E_PCheckStatusType status) {
    add(config, state, status);
    if (within(state, config->MaxErrorStateInit, config->MinOkStateInit)) {
        become_valid(config, state);
    } else if (state->ErrorCount > config->MaxErrorStateInit) {
        become_invalid(config, state);
    }
}

static void step_valid(const E2E_SMConfigType *config, E2E_SMCheckStateType *state,
                       E2E_PCheckStatusType status) {
    add(config, state, status);
    if (!within(state, config->MaxErrorStateValid, config->MinOkStateValid)) {
        become_invalid(config, state);
    }
}

static void step_invalid(const E2E_SMConfigType *config, E2E_SMCheckStateType *state,
                         E2E_PCheckStatusType status) {
    add(config, state, status);
    if (within(state, config->MaxErrorStateInvalid, config->MinOkStateInvalid)) {
        become_valid(config, state);
    }
}

Std_ReturnType E2E_SMCheckConfig(const E2E_SMConfigType *ConfigPtr) {
    const E2E_SMConfigType *c = ConfigPtr;
    if (c == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    const int windows = c->WindowSizeValid >= 1 && c->WindowSizeInit <= c->WindowSizeValid &&
                        c->WindowSizeInvalid <= c->WindowSizeValid;
    const int errors = c->MaxErrorStateValid >= c->MaxErrorStateInit &&
                       c->MaxErrorStateInit >= c->MaxErrorStateInvalid;
    const int oks = c->MinOkStateValid >= 1 && c->MinOkStateInit >= c->MinOkStateValid &&
                    c->MinOkStateInvalid >= c->MinOkStateInit;
    const int sums = c->MinOkStateInit + c->MaxErrorStateInit <= c->WindowSizeInit &&
                     c->MinOkStateValid + c->MaxErrorStateValid <= c->WindowSizeValid &&
                     c->MinOkStateInvalid + c->MaxErrorStateInvalid <= c->WindowSizeInvalid;
    return windows && errors && oks && sums ? E2E_E_OK : E2E_E_INPUTERR_WRONG;
}

Std_ReturnType E2E_SMCheckInit(E2E_SMCheckStateType *StatePtr, const E2E_SMConfigType *ConfigPtr) {
    if (StatePtr == NULL || ConfigPtr == NULL || StatePtr->ProfileStatusWindow == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (ConfigPtr->WindowSizeValid == 0) {
        return E2E_E_INPUTERR_WRONG;
    }
    clear(ConfigPtr, StatePtr);
    StatePtr->SMState = E2E_SM_NODATA;
    return E2E_E_OK;
}

Std_ReturnType E2E_SMCheck(E2E_PCheckStatusType ProfileStatus, const E2E_SMConfigType *ConfigPtr,
                           E2E_SMCheckStateType *StatePtr) {
    if (ConfigPtr == NULL || StatePtr == NULL || StatePtr->ProfileStatusWindow == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (StatePtr->SMState == E2E_SM_DEINIT) {
        return E2E_E_WRONGSTATE;
    }
    if ((uint32)ProfileStatus > E2E_P_NONEWDATA || ConfigPtr->WindowSizeValid == 0) {
        return E2E_E_INPUTERR_WRONG;
    }
    if (StatePtr->WindowTopIndex >= ConfigPtr->WindowSizeValid) {
        return E2E_E_INTERR;
    }
    switch (StatePtr->SMState) {
    case E2E_SM_NODATA:
        step_nodata(ConfigPtr, StatePtr, ProfileStatus);
        return E2E_E_OK;
    case E2E_SM_INIT:
        step_init(ConfigPtr, StatePtr, ProfileStatus);
        return E2E_E_OK;
    case E2E_SM_VALID:
        step_valid(ConfigPtr, StatePtr, ProfileStatus);
        return E2E_E_OK;
    case E2E_SM_INVALID:
        step_invalid(ConfigPtr, StatePtr, ProfileStatus);
        return E2E_E_OK;
    default:
        return E2E_E_INTERR;
    }
}
