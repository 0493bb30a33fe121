/* Profile 8: CRC32P4 4, Length 4, Counter 4, Data ID 4 bytes. */
#include "Crc.h"
#include "E2E_P08.h"
#include "byte_order.h"
#include "check_rules.h"

#define HEADER 16U
#define LENGTH 4U
#define COUNTER 8U
#define ID 12U

/* Of all bytes but the four that hold it. */
static uint32 packet_crc(const uint8 *data, uint32 length, uint32 at) {
    const uint32 after = at + LENGTH;
    const uint32 crc = Crc_CalculateCRC32P4(data, at, 0, TRUE);
    return Crc_CalculateCRC32P4(data + after, length - after, crc, FALSE);
}

static int packet_is_intact(const uint8 *data, uint32 length, uint32 at, uint32 id) {
    const uint8 *header = data + at;
    return Get_Be32(header + LENGTH) == length && Get_Be32(header + ID) == id &&
           Get_Be32(header) == packet_crc(data, length, at);
}

static int length_fits(const E2E_P08ConfigType *config, uint32 length) {
    return Length_IsWithin(length, config->MinDataLength, config->MaxDataLength) &&
           Length_HoldsHeader(length, config->Offset, HEADER);
}

Std_ReturnType E2E_P08CheckConfig(const E2E_P08ConfigType *Config) {
    if (Config == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    return Config->MaxDeltaCounter > 0 &&
                   Config_RangeIsSound(Config->Offset, 8U * HEADER, Config->MinDataLength,
                                       Config->MaxDataLength, 0xFFFFFFFFU)
               ? E2E_E_OK
               : E2E_E_INPUTERR_WRONG;
}

Std_ReturnType E2E_P08ProtectInit(E2E_P08ProtectStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Counter = 0;
    return E2E_E_OK;
}

Std_ReturnType E2E_P08Protect(const E2E_P08ConfigType *Config, E2E_P08ProtectStateType *State,
                              uint8 *Data, uint32 Length) {
    if (Config == NULL || State == NULL || Data == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (!length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    const uint32 at = Config->Offset / 8U;
    uint8 *header = Data + at;
    Put_Be32(header + LENGTH, Length);
    Put_Be32(header + COUNTER, State->Counter);
    Put_Be32(header + ID, Config->DataID);
    Put_Be32(header, packet_crc(Data, Length, at));
    State->Counter++;
    return E2E_E_OK;
}

Std_ReturnType E2E_P08CheckInit(E2E_P08CheckStateType *State) {
    if (State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    State->Status = E2E_P08STATUS_ERROR;
    State->Counter = 0xFFFFFFFFU;
    return E2E_E_OK;
}

Std_ReturnType E2E_P08Check(const E2E_P08ConfigType *Config, E2E_P08CheckStateType *State,
                            const uint8 *Data, uint32 Length) {
    if (Config == NULL || State == NULL) {
        return E2E_E_INPUTERR_NULL;
    }
    if (Data == NULL && Length == 0) {
        State->Status = E2E_P08STATUS_NONEWDATA;
        return E2E_E_OK;
    }
    if (Data == NULL || !length_fits(Config, Length)) {
        return E2E_E_INPUTERR_WRONG;
    }
    const uint32 at = Config->Offset / 8U;
    if (!packet_is_intact(Data, Length, at, Config->DataID)) {
        State->Status = E2E_P08STATUS_ERROR;
        return E2E_E_OK;
    }
    const uint32 received = Get_Be32(Data + at + COUNTER);
    const uint32 delta = received - State->Counter;
    State->Status = (E2E_P08CheckStatusType)Sequence_Status(delta, Config->MaxDeltaCounter);
    State->Counter = received;
    return E2E_E_OK;
}

E2E_PCheckStatusType E2E_P08MapStatusToSM(Std_ReturnType CheckReturn,
                                          E2E_P08CheckStatusType Status) {
    return Status_ToSM(CheckReturn, Status);
}
