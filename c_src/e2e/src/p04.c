/* Profile 4: protect, check and configuration. */
#include "E2E_P04.h"
#include "check_rules.h"
#include "p04_packet.h"

static int length_fits(const E2E_P04ConfigType *config, uint16 length) {
    return Length_IsWithin(length, config->MinDataLength, config->MaxDataLength) &&
           Length_HoldsHeader(length, config->Offset, P04_HEADER);
}

Std_ReturnType E2E_P04CheckConfig(const E2E_P04ConfigType *Config) {
    if (Config == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    return Config->MaxDeltaCounter > 0 &&
                   Config_RangeIsSound(Config->Offset, 8U * P04_HEADER, Config->MinDataLength,
                                       Config->MaxDataLength, 32768U)
               ? E2E_E_OK
               : E2E_E_INPUTERR_WRONG;
}

Std_ReturnType E2E_P04ProtectInit(E2E_P04ProtectStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Counter = 0;
    return E2E_E_OK;
}

Std_ReturnType E2E_P04Protect(const E2E_P04ConfigType *Config, E2E_P04ProtectStateType *State,
                              uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL || Data == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (!length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    P04_Write(Data, Length, Config->Offset / 8U, State->Counter, Config->DataID);
    State->Counter++;
    return E2E_E_OK;
}

Std_ReturnType E2E_P04CheckInit(E2E_P04CheckStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Status = E2E_P04STATUS_ERROR;
    State->Counter = 0xFFFF;
    return E2E_E_OK;
}

Std_ReturnType E2E_P04Check(const E2E_P04ConfigType *Config, E2E_P04CheckStateType *State,
                            const uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (Data == NULL && Length == 0) {
        State->Status = E2E_P04STATUS_NONEWDATA;
        return E2E_E_OK;
    }
    if (Data == NULL || !length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    const uint32 at = Config->Offset / 8U;
    if (!P04_IsIntact(Data, Length, at, Config->DataID)) {
        State->Status = E2E_P04STATUS_ERROR;
        return E2E_E_OK;
    }
    const uint16 received = P04_Counter(Data, at);
    const uint16 delta = (uint16)(received - State->Counter);
    State->Status = (E2E_P04CheckStatusType)Sequence_Status(delta, Config->MaxDeltaCounter);
    State->Counter = received;
    return E2E_E_OK;
}

E2E_PCheckStatusType E2E_P04MapStatusToSM(Std_ReturnType CheckReturn,
                                          E2E_P04CheckStatusType Status) {
    return Status_ToSM(CheckReturn, Status);
}
