/* Profile 5: CRC16 2 bytes, low byte first; Counter 1 byte. */
#include "Crc.h"
#include "E2E_P05.h"
#include "check_rules.h"

#define HEADER 3U
#define COUNTER 2U

/* Of all bytes but the two that hold it, then the Data ID, low byte first. */
static uint16 packet_crc(const uint8 *data, uint32 length, uint32 at, uint16 id) {
    const uint8 id_bytes[2] = {(uint8)id, (uint8)(id >> 8)};
    const uint32 after = at + COUNTER;
    uint16 crc = Crc_CalculateCRC16(data, at, 0, TRUE);
    crc = Crc_CalculateCRC16(data + after, length - after, crc, FALSE);
    return Crc_CalculateCRC16(id_bytes, sizeof id_bytes, crc, FALSE);
}

static uint16 crc_received(const uint8 *header) {
    return (uint16)(header[0] | (header[1] << 8));
}

static int length_fits(const E2E_P05ConfigType *config, uint16 length) {
    return 8U * length == config->DataLength && Length_HoldsHeader(length, config->Offset, HEADER);
}

Std_ReturnType E2E_P05CheckConfig(const E2E_P05ConfigType *Config) {
    if (Config == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    return Config->MaxDeltaCounter > 0 && Config->DataLength % 8U == 0 &&
                   Config_RangeIsSound(Config->Offset, 8U * HEADER, Config->DataLength,
                                       Config->DataLength, 32768U)
               ? E2E_E_OK
               : E2E_E_INPUTERR_WRONG;
}

Std_ReturnType E2E_P05ProtectInit(E2E_P05ProtectStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Counter = 0;
    return E2E_E_OK;
}

Std_ReturnType E2E_P05Protect(const E2E_P05ConfigType *Config, E2E_P05ProtectStateType *State,
                              uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL || Data == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (!length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    const uint32 at = Config->Offset / 8U;
    Data[at + COUNTER] = State->Counter;
    const uint16 crc = packet_crc(Data, Length, at, Config->DataID);
    Data[at] = (uint8)crc;
    Data[at + 1U] = (uint8)(crc >> 8);
    State->Counter++;
    return E2E_E_OK;
}

Std_ReturnType E2E_P05CheckInit(E2E_P05CheckStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Status = E2E_P05STATUS_ERROR;
    State->Counter = 0xFF;
    return E2E_E_OK;
}

Std_ReturnType E2E_P05Check(const E2E_P05ConfigType *Config, E2E_P05CheckStateType *State,
                            const uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (Data == NULL && Length == 0) {
        State->Status = E2E_P05STATUS_NONEWDATA;
        return E2E_E_OK;
    }
    if (Data == NULL || !length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    const uint32 at = Config->Offset / 8U;
    if (crc_received(Data + at) != packet_crc(Data, Length, at, Config->DataID)) {
        State->Status = E2E_P05STATUS_ERROR;
        return E2E_E_OK;
    }
    const uint8 received = Data[at + COUNTER];
    const uint8 delta = (uint8)(received - State->Counter);
    State->Status = (E2E_P05CheckStatusType)Sequence_Status(delta, Config->MaxDeltaCounter);
    State->Counter = received;
    return E2E_E_OK;
}

E2E_PCheckStatusType E2E_P05MapStatusToSM(Std_ReturnType CheckReturn,
                                          E2E_P05CheckStatusType Status) {
    return Status_ToSM(CheckReturn, Status);
}
