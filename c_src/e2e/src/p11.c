/* Profile 11: the packet of profile 1, checked by the rules of the later profiles. */
#include "E2E_P11.h"
#include "check_rules.h"
#include "p01_packet.h"

#define TOP (P01_COUNTERS - 1U)

static uint8 packet_crc(const E2E_P11ConfigType *config, const uint8 *data) {
    const int nibble = config->DataIDMode == E2E_P11_DATAID_NIBBLE;
    const uint8 high = nibble ? 0 : (uint8)(config->DataID >> 8);
    return P01_Crc(P01_IdBytes((uint8)config->DataID, high), data, config->DataLength / 8U,
                   config->CRCOffset / 8U);
}

static uint8 id_nibble(const E2E_P11ConfigType *config) {
    return (uint8)((config->DataID >> 8) & 0x0FU);
}

static int length_fits(const E2E_P11ConfigType *config, uint16 length) {
    return 8U * length == config->DataLength && config->CRCOffset < config->DataLength &&
           config->CounterOffset < config->DataLength &&
           (config->DataIDMode != E2E_P11_DATAID_NIBBLE ||
            config->DataIDNibbleOffset < config->DataLength);
}

static int packet_is_intact(const E2E_P11ConfigType *config, const uint8 *data) {
    return data[config->CRCOffset / 8U] == packet_crc(config, data) &&
           Nibble_Read(data, config->CounterOffset) <= TOP &&
           (config->DataIDMode != E2E_P11_DATAID_NIBBLE ||
            Nibble_Read(data, config->DataIDNibbleOffset) == id_nibble(config));
}

static int id_fits_mode(const E2E_P11ConfigType *config) {
    switch (config->DataIDMode) {
    case E2E_P11_DATAID_BOTH:
        return 1;
    case E2E_P11_DATAID_NIBBLE:
        return config->DataID <= 0x0FFF && config->DataIDNibbleOffset % 4U == 0 &&
               config->DataIDNibbleOffset / 8U != config->CRCOffset / 8U &&
               config->DataIDNibbleOffset != config->CounterOffset;
    }
    return 0;
}

Std_ReturnType E2E_P11CheckConfig(const E2E_P11ConfigType *Config) {
    if (Config == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    const int sizes_fit = Config->DataLength >= 16 && Config->DataLength <= 240 &&
                          length_fits(Config, Config->DataLength / 8U);
    const int fields_fit = Config->CRCOffset % 8U == 0 && Config->CounterOffset % 4U == 0 &&
                           Config->CounterOffset / 8U != Config->CRCOffset / 8U;
    const int limits_fit = Config->MaxDeltaCounter >= 1 && Config->MaxDeltaCounter <= TOP;
    return sizes_fit && fields_fit && limits_fit && id_fits_mode(Config) ? E2E_E_OK
                                                                         : E2E_E_INPUTERR_WRONG;
}

Std_ReturnType E2E_P11ProtectInit(E2E_P11ProtectStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Counter = 0;
    return E2E_E_OK;
}

Std_ReturnType E2E_P11Protect(const E2E_P11ConfigType *Config, E2E_P11ProtectStateType *State,
                              uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL || Data == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (!length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    Nibble_Write(Data, Config->CounterOffset, State->Counter);
    if (Config->DataIDMode == E2E_P11_DATAID_NIBBLE) {
        Nibble_Write(Data, Config->DataIDNibbleOffset, id_nibble(Config));
    }
    Data[Config->CRCOffset / 8U] = packet_crc(Config, Data);
    State->Counter = (uint8)((State->Counter + 1U) % P01_COUNTERS);
    return E2E_E_OK;
}

Std_ReturnType E2E_P11CheckInit(E2E_P11CheckStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Status = E2E_P11STATUS_ERROR;
    State->Counter = TOP;
    return E2E_E_OK;
}

Std_ReturnType E2E_P11Check(const E2E_P11ConfigType *Config, E2E_P11CheckStateType *State,
                            const uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (Data == NULL && Length == 0) {
        State->Status = E2E_P11STATUS_NONEWDATA;
        return E2E_E_OK;
    }
    if (Data == NULL || !length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    if (!packet_is_intact(Config, Data)) {
        State->Status = E2E_P11STATUS_ERROR;
        return E2E_E_OK;
    }
    const uint8 received = Nibble_Read(Data, Config->CounterOffset);
    const uint8 delta =
        (uint8)((received + P01_COUNTERS - State->Counter % P01_COUNTERS) % P01_COUNTERS);
    State->Status = (E2E_P11CheckStatusType)Sequence_Status(delta, Config->MaxDeltaCounter);
    State->Counter = received;
    return E2E_E_OK;
}

E2E_PCheckStatusType E2E_P11MapStatusToSM(Std_ReturnType CheckReturn,
                                          E2E_P11CheckStatusType Status) {
    return Status_ToSM(CheckReturn, Status);
}
