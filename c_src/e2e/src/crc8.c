/* CRC8 SAE J1850 and CRC8H2F: most significant bit first, start and final XOR 0xFF. */
#include "Crc.h"
#include "crc_method.h"

#if E2E_CRC_METHOD == E2E_CRC_BITWISE

typedef uint8 divisor; /* the polynomial */
static const divisor j1850 = 0x1D;
static const divisor h2f = 0x2F;

static uint8 run(const divisor *poly, uint8 reg, const uint8 *data, uint32 length) {
    for (uint32 i = 0; i < length; i++) {
        reg ^= data[i];
        for (int bit = 0; bit < 8; bit++) {
            reg = (uint8)((reg << 1) ^ ((reg & 0x80) ? *poly : 0));
        }
    }
    return reg;
}

#else

typedef struct {
    uint8 row[CRC_ROWS][256];
} divisor;

static const divisor j1850 = {CRC_TABLE((0x1d, 0x3a, 0x74, 0xe8, 0xcd, 0x87, 0x13, 0x26),
                                        (0x4c, 0x98, 0x2d, 0x5a, 0xb4, 0x75, 0xea, 0xc9),
                                        (0x8f, 0x03, 0x06, 0x0c, 0x18, 0x30, 0x60, 0xc0),
                                        (0x9d, 0x27, 0x4e, 0x9c, 0x25, 0x4a, 0x94, 0x35),
                                        (0x6a, 0xd4, 0xb5, 0x77, 0xee, 0xc1, 0x9f, 0x23),
                                        (0x46, 0x8c, 0x05, 0x0a, 0x14, 0x28, 0x50, 0xa0),
                                        (0x5d, 0xba, 0x69, 0xd2, 0xb9, 0x6f, 0xde, 0xa1),
                                        (0x5f, 0xbe, 0x61, 0xc2, 0x99, 0x2f, 0x5e, 0xbc))};

static const divisor h2f = {CRC_TABLE((0x2f, 0x5e, 0xbc, 0x57, 0xae, 0x73, 0xe6, 0xe3),
                                      (0xe9, 0xfd, 0xd5, 0x85, 0x25, 0x4a, 0x94, 0x07),
                                      (0x0e, 0x1c, 0x38, 0x70, 0xe0, 0xef, 0xf1, 0xcd),
                                      (0xb5, 0x45, 0x8a, 0x3b, 0x76, 0xec, 0xf7, 0xc1),
                                      (0xad, 0x75, 0xea, 0xfb, 0xd9, 0x9d, 0x15, 0x2a),
                                      (0x54, 0xa8, 0x7f, 0xfe, 0xd3, 0x89, 0x3d, 0x7a),
                                      (0xf4, 0xc7, 0xa1, 0x6d, 0xda, 0x9b, 0x19, 0x32),
                                      (0x64, 0xc8, 0xbf, 0x51, 0xa2, 0x6b, 0xd6, 0x83))};

static uint8 run(const divisor *t, uint8 reg, const uint8 *data, uint32 length) {
    uint32 i = 0;
    while (i < length) {
        const uint32 rest = length - i;
        const uint32 chunk = rest < CRC_ROWS ? rest : CRC_ROWS;
        uint8 sum = t->row[chunk - 1][reg ^ data[i++]];
        for (uint32 k = chunk - 1; k > 0; k--) {
            sum ^= t->row[k - 1][data[i++]];
        }
        reg = sum;
    }
    return reg;
}

#endif

static uint8 calculate(const divisor *by, const uint8 *data, uint32 length, uint8 start,
                       boolean first) {
    const uint8 reg = first ? 0xFF : (uint8)(start ^ 0xFF);
    return (uint8)(run(by, reg, data, length) ^ 0xFF);
}

uint8 Crc_CalculateCRC8(const uint8 *Data, uint32 Length, uint8 StartValue, boolean IsFirstCall) {
    return calculate(&j1850, Data, Length, StartValue, IsFirstCall);
}

uint8 Crc_CalculateCRC8H2F(const uint8 *Data, uint32 Length, uint8 StartValue,
                           boolean IsFirstCall) {
    return calculate(&h2f, Data, Length, StartValue, IsFirstCall);
}
