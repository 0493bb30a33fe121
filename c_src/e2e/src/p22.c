/* Profile 22: the packet of profile 2 at any place, checked by the rules of the later profiles. */
#include "E2E_P22.h"
#include "check_rules.h"
#include "p02_packet.h"

static int length_fits(const E2E_P22ConfigType *config, uint16 length) {
    return 8U * length == config->DataLength &&
           Length_HoldsHeader(length, config->Offset, P02_HEADER);
}

Std_ReturnType E2E_P22CheckConfig(const E2E_P22ConfigType *Config) {
    if (Config == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    return Config->MaxDeltaCounter >= 1 && Config->MaxDeltaCounter < P02_COUNTERS &&
                   Config->DataLength % 8U == 0 &&
                   Config_RangeIsSound(Config->Offset, 8U * P02_HEADER, Config->DataLength,
                                       Config->DataLength, P02_MAX_BITS)
               ? E2E_E_OK
               : E2E_E_INPUTERR_WRONG;
}

Std_ReturnType E2E_P22ProtectInit(E2E_P22ProtectStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Counter = 0;
    return E2E_E_OK;
}

Std_ReturnType E2E_P22Protect(const E2E_P22ConfigType *Config, E2E_P22ProtectStateType *State,
                              uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL || Data == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (!length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    State->Counter = (uint8)((State->Counter + 1U) % P02_COUNTERS);
    P02_Write(Data, Length, Config->Offset / 8U, State->Counter, Config->DataIDList);
    return E2E_E_OK;
}

Std_ReturnType E2E_P22CheckInit(E2E_P22CheckStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Status = E2E_P22STATUS_ERROR;
    State->Counter = P02_COUNTERS - 1U;
    return E2E_E_OK;
}

Std_ReturnType E2E_P22Check(const E2E_P22ConfigType *Config, E2E_P22CheckStateType *State,
                            const uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (Data == NULL && Length == 0) {
        State->Status = E2E_P22STATUS_NONEWDATA;
        return E2E_E_OK;
    }
    if (Data == NULL || !length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    const uint32 at = Config->Offset / 8U;
    if (!P02_IsIntact(Data, Length, at, Config->DataIDList)) {
        State->Status = E2E_P22STATUS_ERROR;
        return E2E_E_OK;
    }
    const uint8 received = P02_Counter(Data, at);
    const uint8 delta = (uint8)((received - State->Counter) & (P02_COUNTERS - 1U));
    State->Status = (E2E_P22CheckStatusType)Sequence_Status(delta, Config->MaxDeltaCounter);
    State->Counter = received;
    return E2E_E_OK;
}

E2E_PCheckStatusType E2E_P22MapStatusToSM(Std_ReturnType CheckReturn,
                                          E2E_P22CheckStatusType Status) {
    return Status_ToSM(CheckReturn, Status);
}
