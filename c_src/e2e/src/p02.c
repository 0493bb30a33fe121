/* Profile 2: the counter rules of profile 1, with 16 values, on a packet of its own. */
#include "E2E_P02.h"
#include "check_rules.h"
#include "p01_sequence.h"
#include "p02_packet.h"

#define TOP (P02_COUNTERS - 1U)

static int header_fits(const E2E_P02ConfigType *config) {
    return Length_HoldsHeader(config->DataLength / 8U, config->Offset, P02_HEADER);
}

Std_ReturnType E2E_P02CheckConfig(const E2E_P02ConfigType *Config) {
    if (Config == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    const int sizes_fit = Config->DataLength % 8U == 0 &&
                          Config_RangeIsSound(Config->Offset, 8U * P02_HEADER, Config->DataLength,
                                              Config->DataLength, P02_MAX_BITS);
    const int limits_fit = Config->MaxDeltaCounterInit <= TOP &&
                           Config->MaxNoNewOrRepeatedData <= TOP && Config->SyncCounterInit <= TOP;
    return sizes_fit && limits_fit ? E2E_E_OK : E2E_E_INPUTERR_WRONG;
}

Std_ReturnType E2E_P02ProtectInit(E2E_P02ProtectStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Counter = 0;
    return E2E_E_OK;
}

Std_ReturnType E2E_P02Protect(const E2E_P02ConfigType *Config, E2E_P02ProtectStateType *State,
                              uint8 *Data) {
    if (Config == NULL || State == NULL || Data == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (!header_fits(Config)) {
        return E2E_E_INPUTERR_WRONG;
    }
    State->Counter = (uint8)((State->Counter + 1U) % P02_COUNTERS);
    P02_Write(Data, Config->DataLength / 8U, Config->Offset / 8U, State->Counter,
              Config->DataIDList);
    return E2E_E_OK;
}

Std_ReturnType E2E_P02CheckInit(E2E_P02CheckStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->LastValidCounter = 0;
    State->MaxDeltaCounter = 0;
    State->WaitForFirstData = TRUE;
    State->NewDataAvailable = TRUE;
    State->LostData = 0;
    State->Status = E2E_P02STATUS_NONEWDATA;
    State->SyncCounter = 0;
    State->NoNewOrRepeatedDataCounter = 0;
    return E2E_E_OK;
}

static E2E_P02CheckStatusType accept(const E2E_P02ConfigType *config, E2E_P02CheckStateType *state,
                                     uint8 received) {
    const Limits limits = {P02_COUNTERS, config->MaxDeltaCounterInit,
                           config->MaxNoNewOrRepeatedData, config->SyncCounterInit};
    Progress p = {state->LastValidCounter, state->MaxDeltaCounter, state->LostData,
                  state->SyncCounter, state->NoNewOrRepeatedDataCounter};
    const E2E_P01CheckStatusType status = P01_Sequence(&limits, &p, received);
    state->LastValidCounter = p.last_valid;
    state->MaxDeltaCounter = p.max_delta;
    state->LostData = p.lost;
    state->SyncCounter = p.sync;
    state->NoNewOrRepeatedDataCounter = p.no_new_or_repeated;
    return (E2E_P02CheckStatusType)status; /* the same values */
}

Std_ReturnType E2E_P02Check(const E2E_P02ConfigType *Config, E2E_P02CheckStateType *State,
                            const uint8 *Data) {
    if (Config == NULL || State == NULL || Data == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (!header_fits(Config)) {
        return E2E_E_INPUTERR_WRONG;
    }
    State->MaxDeltaCounter = P01_CountUp(State->MaxDeltaCounter, P02_COUNTERS);
    if (!State->NewDataAvailable) {
        State->NoNewOrRepeatedDataCounter =
            P01_CountUp(State->NoNewOrRepeatedDataCounter, P02_COUNTERS);
        State->Status = E2E_P02STATUS_NONEWDATA;
        return E2E_E_OK;
    }
    const uint32 at = Config->Offset / 8U;
    const uint8 received = P02_Counter(Data, at);
    if (!P02_IsIntact(Data, Config->DataLength / 8U, at, Config->DataIDList)) {
        State->Status = E2E_P02STATUS_WRONGCRC;
    } else if (State->WaitForFirstData) {
        State->WaitForFirstData = FALSE;
        State->MaxDeltaCounter = Config->MaxDeltaCounterInit;
        State->LastValidCounter = received;
        State->Status = E2E_P02STATUS_INITIAL;
    } else {
        State->Status = accept(Config, State, received);
    }
    return E2E_E_OK;
}

E2E_PCheckStatusType E2E_P02MapStatusToSM(Std_ReturnType CheckReturn, E2E_P02CheckStatusType Status,
                                          boolean profileBehavior) {
    return P01_ToSM(CheckReturn, (E2E_P01CheckStatusType)Status, profileBehavior);
}
