/* CRC16 CCITT-FALSE (most significant bit first) and CRC16 ARC (reflected). Neither has a final
 * XOR. */
#include "Crc.h"
#include "crc_method.h"

#if E2E_CRC_METHOD == E2E_CRC_BITWISE

static uint16 run_ccitt(uint16 reg, const uint8 *data, uint32 length) {
    for (uint32 i = 0; i < length; i++) {
        reg ^= (uint16)(data[i] << 8);
        for (int bit = 0; bit < 8; bit++) {
            reg = (uint16)((reg << 1) ^ ((reg & 0x8000) ? 0x1021 : 0));
        }
    }
    return reg;
}

static uint16 run_arc(uint16 reg, const uint8 *data, uint32 length) {
    for (uint32 i = 0; i < length; i++) {
        reg ^= data[i];
        for (int bit = 0; bit < 8; bit++) {
            reg = (uint16)((reg >> 1) ^ ((reg & 1) ? 0xA001 : 0));
        }
    }
    return reg;
}

#else

static const uint16 ccitt[CRC_ROWS][256] =
    CRC_TABLE((0x1021, 0x2042, 0x4084, 0x8108, 0x1231, 0x2462, 0x48c4, 0x9188),
              (0x3331, 0x6662, 0xccc4, 0x89a9, 0x0373, 0x06e6, 0x0dcc, 0x1b98),
              (0x3730, 0x6e60, 0xdcc0, 0xa9a1, 0x4363, 0x86c6, 0x1dad, 0x3b5a),
              (0x76b4, 0xed68, 0xcaf1, 0x85c3, 0x1ba7, 0x374e, 0x6e9c, 0xdd38),
              (0xaa51, 0x4483, 0x8906, 0x022d, 0x045a, 0x08b4, 0x1168, 0x22d0),
              (0x45a0, 0x8b40, 0x06a1, 0x0d42, 0x1a84, 0x3508, 0x6a10, 0xd420),
              (0xb861, 0x60e3, 0xc1c6, 0x93ad, 0x377b, 0x6ef6, 0xddec, 0xabf9),
              (0x47d3, 0x8fa6, 0x0f6d, 0x1eda, 0x3db4, 0x7b68, 0xf6d0, 0xfd81));

static const uint16 arc[CRC_ROWS][256] =
    CRC_TABLE((0xc0c1, 0xc181, 0xc301, 0xc601, 0xcc01, 0xd801, 0xf001, 0xa001),
              (0x9001, 0x6001, 0xc002, 0xc007, 0xc00d, 0xc019, 0xc031, 0xc061),
              (0xc051, 0xc0a1, 0xc141, 0xc281, 0xc501, 0xca01, 0xd401, 0xe801),
              (0xfc01, 0xb801, 0x3001, 0x6002, 0xc004, 0xc00b, 0xc015, 0xc029),
              (0xc03d, 0xc079, 0xc0f1, 0xc1e1, 0xc3c1, 0xc781, 0xcf01, 0xde01),
              (0xd101, 0xe201, 0x8401, 0x4801, 0x9002, 0x6007, 0xc00e, 0xc01f),
              (0xc010, 0xc023, 0xc045, 0xc089, 0xc111, 0xc221, 0xc441, 0xc881),
              (0xccc1, 0xd981, 0xf301, 0xa601, 0x0c01, 0x1802, 0x3004, 0x6008));

#if E2E_CRC_METHOD == E2E_CRC_SLICED
/* What the six bytes after the two that meet the register add; the same for both bit orders. */
static uint16 last_six(const uint16 (*t)[256], const uint8 *p) {
    return (uint16)(t[5][p[2]] ^ t[4][p[3]] ^ t[3][p[4]] ^ t[2][p[5]] ^ t[1][p[6]] ^ t[0][p[7]]);
}
#endif

static uint16 run_ccitt(uint16 reg, const uint8 *data, uint32 length) {
    uint32 i = 0;
#if E2E_CRC_METHOD == E2E_CRC_SLICED
    for (; length - i >= 8; i += 8) {
        const uint8 *p = data + i;
        reg = (uint16)(ccitt[7][(reg >> 8) ^ p[0]] ^ ccitt[6][(reg & 0xFF) ^ p[1]] ^
                       last_six(ccitt, p));
    }
#endif
    for (; i < length; i++) {
        reg = (uint16)((reg << 8) ^ ccitt[0][(reg >> 8) ^ data[i]]);
    }
    return reg;
}

static uint16 run_arc(uint16 reg, const uint8 *data, uint32 length) {
    uint32 i = 0;
#if E2E_CRC_METHOD == E2E_CRC_SLICED
    for (; length - i >= 8; i += 8) {
        const uint8 *p = data + i;
        reg = (uint16)(arc[7][(reg & 0xFF) ^ p[0]] ^ arc[6][(reg >> 8) ^ p[1]] ^ last_six(arc, p));
    }
#endif
    for (; i < length; i++) {
        reg = (uint16)((reg >> 8) ^ arc[0][(reg & 0xFF) ^ data[i]]);
    }
    return reg;
}

#endif

uint16 Crc_CalculateCRC16(const uint8 *Data, uint32 Length, uint16 StartValue,
                          boolean IsFirstCall) {
    return run_ccitt(IsFirstCall ? 0xFFFF : StartValue, Data, Length);
}

uint16 Crc_CalculateCRC16ARC(const uint8 *Data, uint32 Length, uint16 StartValue,
                             boolean IsFirstCall) {
    return run_arc(IsFirstCall ? 0 : StartValue, Data, Length);
}
