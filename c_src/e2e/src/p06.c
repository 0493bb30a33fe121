/* Profile 6: CRC16 2 bytes, high byte first; Length 2 bytes; Counter 1 byte. */
#include "Crc.h"
#include "E2E_P06.h"
#include "byte_order.h"
#include "check_rules.h"

#define HEADER 5U
#define LENGTH 2U
#define COUNTER 4U

/* Of all bytes but the two that hold it, then the Data ID, high byte first. */
static uint16 packet_crc(const uint8 *data, uint32 length, uint32 at, uint16 id) {
    const uint8 id_bytes[2] = {(uint8)(id >> 8), (uint8)id};
    const uint32 after = at + LENGTH;
    uint16 crc = Crc_CalculateCRC16(data, at, 0, TRUE);
    crc = Crc_CalculateCRC16(data + after, length - after, crc, FALSE);
    return Crc_CalculateCRC16(id_bytes, sizeof id_bytes, crc, FALSE);
}

static int packet_is_intact(const uint8 *data, uint16 length, uint32 at, uint16 id) {
    const uint8 *header = data + at;
    return Get_Be16(header + LENGTH) == length &&
           Get_Be16(header) == packet_crc(data, length, at, id);
}

static int length_fits(const E2E_P06ConfigType *config, uint16 length) {
    return Length_IsWithin(length, config->MinDataLength, config->MaxDataLength) &&
           Length_HoldsHeader(length, config->Offset, HEADER);
}

Std_ReturnType E2E_P06CheckConfig(const E2E_P06ConfigType *Config) {
    if (Config == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    return Config->MaxDeltaCounter > 0 &&
                   Config_RangeIsSound(Config->Offset, 8U * HEADER, Config->MinDataLength,
                                       Config->MaxDataLength, 32768U)
               ? E2E_E_OK
               : E2E_E_INPUTERR_WRONG;
}

Std_ReturnType E2E_P06ProtectInit(E2E_P06ProtectStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Counter = 0;
    return E2E_E_OK;
}

Std_ReturnType E2E_P06Protect(const E2E_P06ConfigType *Config, E2E_P06ProtectStateType *State,
                              uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL || Data == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (!length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    const uint32 at = Config->Offset / 8U;
    Put_Be16(Data + at + LENGTH, Length);
    Data[at + COUNTER] = State->Counter;
    Put_Be16(Data + at, packet_crc(Data, Length, at, Config->DataID));
    State->Counter++;
    return E2E_E_OK;
}

Std_ReturnType E2E_P06CheckInit(E2E_P06CheckStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Status = E2E_P06STATUS_ERROR;
    State->Counter = 0xFF;
    return E2E_E_OK;
}

Std_ReturnType E2E_P06Check(const E2E_P06ConfigType *Config, E2E_P06CheckStateType *State,
                            const uint8 *Data, uint16 Length) {
    if (Config == NULL || State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (Data == NULL && Length == 0) {
        State->Status = E2E_P06STATUS_NONEWDATA;
        return E2E_E_OK;
    }
    if (Data == NULL || !length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    const uint32 at = Config->Offset / 8U;
    if (!packet_is_intact(Data, Length, at, Config->DataID)) {
        State->Status = E2E_P06STATUS_ERROR;
        return E2E_E_OK;
    }
    const uint8 received = Data[at + COUNTER];
    const uint8 delta = (uint8)(received - State->Counter);
    State->Status = (E2E_P06CheckStatusType)Sequence_Status(delta, Config->MaxDeltaCounter);
    State->Counter = received;
    return E2E_E_OK;
}

E2E_PCheckStatusType E2E_P06MapStatusToSM(Std_ReturnType CheckReturn,
                                          E2E_P06CheckStatusType Status) {
    return Status_ToSM(CheckReturn, Status);
}
