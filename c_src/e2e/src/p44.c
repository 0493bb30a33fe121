/* Profile 44: as profile 4, with wider limits. */
#include "E2E_P44.h"
#include "check_rules.h"
#include "p04_packet.h"

static int length_fits(const E2E_P44ConfigType *config, uint16 length) {
    return Length_IsWithin(length, config->MinDataLength, config->MaxDataLength) &&
           Length_HoldsHeader(length, config->Offset, P04_HEADER);
}

Std_ReturnType E2E_P44CheckConfig(const E2E_P44ConfigType *Config) {
    if (Config == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    return Config->MaxDeltaCounter > 0 &&
                   Config_RangeIsSound(Config->Offset, 8U * P04_HEADER, Config->MinDataLength,
                                       Config->MaxDataLength, 8U * 65535U)
               ? E2E_E_OK
               : E2E_E_INPUTERR_WRONG;
}

Std_ReturnType E2E_P44ProtectInit(E2E_P44ProtectStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Counter = 0;
    return E2E_E_OK;
}

Std_ReturnType E2E_P44Protect(const E2E_P44ConfigType *Config, E2E_P44ProtectStateType *State,
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

Std_ReturnType E2E_P44CheckInit(E2E_P44CheckStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Status = E2E_P44STATUS_ERROR;
    State->Counter = 0xFFFF;
    return E2E_E_OK;
}

Std_ReturnType E2E_P44Check(const E2E_P44ConfigType *Config, E2E_P44CheckStateType *State,
                            const uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (Data == NULL && Length == 0) {
        State->Status = E2E_P44STATUS_NONEWDATA;
        return E2E_E_OK;
    }
    if (Data == NULL || !length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    const uint32 at = Config->Offset / 8U;
    if (!P04_IsIntact(Data, Length, at, Config->DataID)) {
        State->Status = E2E_P44STATUS_ERROR;
        return E2E_E_OK;
    }
    const uint16 received = P04_Counter(Data, at);
    const uint16 delta = (uint16)(received - State->Counter);
    State->Status = (E2E_P44CheckStatusType)Sequence_Status(delta, Config->MaxDeltaCounter);
    State->Counter = received;
    return E2E_E_OK;
}

E2E_PCheckStatusType E2E_P44MapStatusToSM(Std_ReturnType CheckReturn,
                                          E2E_P44CheckStatusType Status) {
    return Status_ToSM(CheckReturn, Status);
}
