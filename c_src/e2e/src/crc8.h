/* The remainder underneath both CRC8 routines, for callers that need it bare and inlined. */
#ifndef CRC8_H
#define CRC8_H

#include "crc_method.h"

#if E2E_CRC_METHOD == E2E_CRC_BITWISE
typedef struct {
    uint8 polynomial;
} Crc8Divisor;
#else
typedef struct {
    uint8 row[CRC_ROWS][256];
} Crc8Divisor;
#endif

extern E2E_LOCAL const Crc8Divisor Crc8_J1850; /* polynomial 0x1D */
extern E2E_LOCAL const Crc8Divisor Crc8_H2F;   /* polynomial 0x2F */

static inline uint8 Crc8_Byte(const Crc8Divisor *by, uint8 reg, uint8 byte) {
    reg ^= byte;
#if E2E_CRC_METHOD == E2E_CRC_BITWISE
    for (int bit = 0; bit < 8; bit++) {
        reg = (uint8)((reg << 1) ^ ((reg & 0x80) ? by->polynomial : 0));
    }
    return reg;
#else
    return by->row[0][reg];
#endif
}

#if E2E_CRC_METHOD == E2E_CRC_SLICED
/* 1 to 8 bytes, the last of them just before `end`. The register's share and each byte's are
 * independent. */
static inline uint8 Crc8_Slice(const Crc8Divisor *by, uint8 reg, const uint8 *end, uint32 length) {
    uint8 sum = by->row[length - 1U][reg];
    switch (length) {
    case 8:
        sum ^= by->row[7][end[-8]]; /* fall through */
    case 7:
        sum ^= by->row[6][end[-7]]; /* fall through */
    case 6:
        sum ^= by->row[5][end[-6]]; /* fall through */
    case 5:
        sum ^= by->row[4][end[-5]]; /* fall through */
    case 4:
        sum ^= by->row[3][end[-4]]; /* fall through */
    case 3:
        sum ^= by->row[2][end[-3]]; /* fall through */
    case 2:
        sum ^= by->row[1][end[-2]]; /* fall through */
    default:
        sum ^= by->row[0][end[-1]];
    }
    return sum;
}
#endif

/* The register after `length` bytes, most significant bit first. */
static inline uint8 Crc8_Run(const Crc8Divisor *by, uint8 reg, const uint8 *data, uint32 length) {
#if E2E_CRC_METHOD == E2E_CRC_SLICED
    for (; length >= CRC_ROWS; length -= CRC_ROWS, data += CRC_ROWS) {
        reg = Crc8_Slice(by, reg, data + CRC_ROWS, CRC_ROWS);
    }
    return length > 0 ? Crc8_Slice(by, reg, data + length, length) : reg;
#else
    for (uint32 i = 0; i < length; i++) {
        reg = Crc8_Byte(by, reg, data[i]);
    }
    return reg;
#endif
}

#endif
