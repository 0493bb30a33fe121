/* Profile 1: protect, check, configuration and status mapping. */
#include "E2E_P01.h"
#include "p01_packet.h"
#include "p01_sequence.h"

#define TOP (P01_COUNTERS - 1U)

static uint8 id_crc(const E2E_P01ConfigType *config, uint8 counter) {
    const uint8 low = (uint8)(config->DataID & 0xFF);
    const uint8 high = (uint8)(config->DataID >> 8);
    switch (config->DataIDMode) {
    case E2E_P01_DATAID_ALT:
        return P01_IdByte((counter & 1U) ? high : low);
    case E2E_P01_DATAID_LOW:
        return P01_IdByte(low);
    case E2E_P01_DATAID_NIBBLE:
        return P01_IdBytes(low, 0);
    case E2E_P01_DATAID_BOTH:
        break;
    }
    return P01_IdBytes(low, high);
}

static uint8 packet_crc(const E2E_P01ConfigType *config, const uint8 *data, uint8 counter) {
    return P01_Crc(id_crc(config, counter), data, config->DataLength / 8U, config->CRCOffset / 8U);
}

static uint8 id_nibble(const E2E_P01ConfigType *config) {
    return (uint8)((config->DataID >> 8) & 0x0FU);
}

static int packet_is_intact(const E2E_P01ConfigType *config, const uint8 *data, uint8 counter) {
    if (data[config->CRCOffset / 8U] != packet_crc(config, data, counter)) {
        return 0;
    }
    return config->DataIDMode != E2E_P01_DATAID_NIBBLE ||
           Nibble_Read(data, config->DataIDNibbleOffset) == id_nibble(config);
}

static int id_fits_mode(const E2E_P01ConfigType *config) {
    switch (config->DataIDMode) {
    case E2E_P01_DATAID_BOTH:
    case E2E_P01_DATAID_ALT:
        return 1;
    case E2E_P01_DATAID_LOW:
        return config->DataID <= 0x00FF;
    case E2E_P01_DATAID_NIBBLE:
        return config->DataID <= 0x0FFF && config->DataIDNibbleOffset % 4U == 0 &&
               config->DataIDNibbleOffset < config->DataLength &&
               config->DataIDNibbleOffset / 8U != config->CRCOffset / 8U &&
               config->DataIDNibbleOffset != config->CounterOffset;
    }
    return 0;
}

Std_ReturnType E2E_P01CheckConfig(const E2E_P01ConfigType *Config) {
    if (Config == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    const int lengths_fit =
        Config->DataLength >= 16 && Config->DataLength <= 240 && Config->DataLength % 8U == 0;
    const int fields_fit = Config->CRCOffset % 8U == 0 && Config->CRCOffset < Config->DataLength &&
                           Config->CounterOffset % 4U == 0 &&
                           Config->CounterOffset < Config->DataLength &&
                           Config->CounterOffset / 8U != Config->CRCOffset / 8U;
    const int limits_fit = Config->MaxDeltaCounterInit <= TOP &&
                           Config->MaxNoNewOrRepeatedData <= TOP && Config->SyncCounterInit <= TOP;
    return lengths_fit && fields_fit && limits_fit && id_fits_mode(Config) ? E2E_E_OK
                                                                           : E2E_E_INPUTERR_WRONG;
}

Std_ReturnType E2E_P01ProtectInit(E2E_P01ProtectStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Counter = 0;
    return E2E_E_OK;
}

Std_ReturnType E2E_P01Protect(const E2E_P01ConfigType *Config, E2E_P01ProtectStateType *State,
                              uint8 *Data) {
    if (Config == NULL || State == NULL || Data == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    Nibble_Write(Data, Config->CounterOffset, State->Counter);
    if (Config->DataIDMode == E2E_P01_DATAID_NIBBLE) {
        Nibble_Write(Data, Config->DataIDNibbleOffset, id_nibble(Config));
    }
    Data[Config->CRCOffset / 8U] = packet_crc(Config, Data, State->Counter);
    State->Counter = (uint8)((State->Counter + 1U) % P01_COUNTERS);
    return E2E_E_OK;
}

Std_ReturnType E2E_P01CheckInit(E2E_P01CheckStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->LastValidCounter = 0;
    State->MaxDeltaCounter = 0;
    State->WaitForFirstData = TRUE;
    State->NewDataAvailable = TRUE;
    State->LostData = 0;
    State->Status = E2E_P01STATUS_NONEWDATA;
    State->SyncCounter = 0;
    State->NoNewOrRepeatedDataCounter = 0;
    return E2E_E_OK;
}

static E2E_P01CheckStatusType accept(const E2E_P01ConfigType *config, E2E_P01CheckStateType *state,
                                     uint8 received) {
    const Limits limits = {P01_COUNTERS, config->MaxDeltaCounterInit,
                           config->MaxNoNewOrRepeatedData, config->SyncCounterInit};
    Progress p = {state->LastValidCounter, state->MaxDeltaCounter, state->LostData,
                  state->SyncCounter, state->NoNewOrRepeatedDataCounter};
    const E2E_P01CheckStatusType status = P01_Sequence(&limits, &p, received);
    state->LastValidCounter = p.last_valid;
    state->MaxDeltaCounter = p.max_delta;
    state->LostData = p.lost;
    state->SyncCounter = p.sync;
    state->NoNewOrRepeatedDataCounter = p.no_new_or_repeated;
    return status;
}

Std_ReturnType E2E_P01Check(const E2E_P01ConfigType *Config, E2E_P01CheckStateType *State,
                            const uint8 *Data) {
    if (Config == NULL || State == NULL || Data == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->MaxDeltaCounter = P01_CountUp(State->MaxDeltaCounter, P01_COUNTERS);
    if (!State->NewDataAvailable) {
        State->NoNewOrRepeatedDataCounter =
            P01_CountUp(State->NoNewOrRepeatedDataCounter, P01_COUNTERS);
        State->Status = E2E_P01STATUS_NONEWDATA;
        return E2E_E_OK;
    }
    const uint8 received = Nibble_Read(Data, Config->CounterOffset);
    if (received > TOP) {
        return E2E_E_INPUTERR_WRONG;
    }
    if (!packet_is_intact(Config, Data, received)) {
        State->Status = E2E_P01STATUS_WRONGCRC;
    } else if (State->WaitForFirstData) {
        State->WaitForFirstData = FALSE;
        State->MaxDeltaCounter = Config->MaxDeltaCounterInit;
        State->LastValidCounter = received;
        State->Status = E2E_P01STATUS_INITIAL;
    } else {
        State->Status = accept(Config, State, received);
    }
    return E2E_E_OK;
}

E2E_PCheckStatusType E2E_P01MapStatusToSM(Std_ReturnType CheckReturn, E2E_P01CheckStatusType Status,
                                          boolean profileBehavior) {
    return P01_ToSM(CheckReturn, Status, profileBehavior);
}
