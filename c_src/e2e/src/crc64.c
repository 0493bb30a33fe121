/* CRC64 (ECMA): reflected, start and final XOR all ones. */
#include "Crc.h"
#include "crc_method.h"

#if E2E_CRC_METHOD == E2E_CRC_BITWISE

static uint64 run(uint64 reg, const uint8 *data, uint32 length) {
    for (uint32 i = 0; i < length; i++) {
        reg ^= data[i];
        for (int bit = 0; bit < 8; bit++) {
            reg = (reg >> 1) ^ ((reg & 1U) ? 0xC96C5795D7870F42ULL : 0ULL);
        }
    }
    return reg;
}

#else

static const uint64 ecma[CRC_ROWS][256] = CRC_TABLE(
    (0xb32e4cbe03a75f6fULL, 0xf4843657a840a05bULL, 0x7bd0c384ff8f5e33ULL, 0xf7a18709ff1ebc66ULL,
     0x7d9ba13851336649ULL, 0xfb374270a266cc92ULL, 0x64b62bcaebc387a1ULL, 0xc96c5795d7870f42ULL),
    (0x54e979925cd0f10dULL, 0xa9d2f324b9a1e21aULL, 0xc17d4962dc4ddab1ULL, 0x10223dee1795abe7ULL,
     0x20447bdc2f2b57ceULL, 0x4088f7b85e56af9cULL, 0x8111ef70bcad5f38ULL, 0x90fb71cad654a0f5ULL),
    (0x3f0be14a916a6dcbULL, 0x7e17c29522d4db96ULL, 0xfc2f852a45a9b72cULL, 0x6a87a57f245d70ddULL,
     0xd50f4afe48bae1baULL, 0x38c63ad73e7bddf1ULL, 0x718c75ae7cf7bbe2ULL, 0xe318eb5cf9ef77c4ULL),
    (0x1dee8a5e222ca1dcULL, 0x3bdd14bc445943b8ULL, 0x77ba297888b28770ULL, 0xef7452f111650ee0ULL,
     0x4c300ac98dc40345ULL, 0x986015931b88068aULL, 0xa218840d981e1391ULL, 0xd6e9a7309f3239a7ULL),
    (0x5c2d776033c4205eULL, 0xb85aeec0678840bcULL, 0xe26d72ab601e9ffdULL, 0x56024a7d6f33217fULL,
     0xac0494fade6642feULL, 0xcad186de13c29b79ULL, 0x077ba297888b2877ULL, 0x0ef7452f111650eeULL),
    (0x6184d55f721267c6ULL, 0xc309aabee424cf8cULL, 0x14cbfa566747819dULL, 0x2997f4acce8f033aULL,
     0x532fe9599d1e0674ULL, 0xa65fd2b33a3c0ce8ULL, 0xde670a4ddb760755ULL, 0x2e16bbb019e2102fULL),
    (0x22ef0d5934f964ecULL, 0x45de1ab269f2c9d8ULL, 0x8bbc3564d3e593b0ULL, 0x85a0c5e208c539e5ULL,
     0x999924efbe846d4fULL, 0xa1eae6f4d206c41bULL, 0xd10d62c20b0396b3ULL, 0x30c26aafb90933e3ULL),
    (0xdabe95afc7875f40ULL, 0x27a584742000a005ULL, 0x4f4b08e84001400aULL, 0x9e9611d080028014ULL,
     0xaff48c8aaf0b1eadULL, 0xcd31b63ef11823dfULL, 0x08bbc3564d3e593bULL, 0x117786ac9a7cb276ULL));

static uint64 run(uint64 reg, const uint8 *data, uint32 length) {
    uint32 i = 0;
#if E2E_CRC_METHOD == E2E_CRC_SLICED
    for (; length - i >= 8; i += 8) {
        const uint8 *p = data + i;
        reg = ecma[7][(reg & 0xFF) ^ p[0]] ^ ecma[6][((reg >> 8) & 0xFF) ^ p[1]] ^
              ecma[5][((reg >> 16) & 0xFF) ^ p[2]] ^ ecma[4][((reg >> 24) & 0xFF) ^ p[3]] ^
              ecma[3][((reg >> 32) & 0xFF) ^ p[4]] ^ ecma[2][((reg >> 40) & 0xFF) ^ p[5]] ^
              ecma[1][((reg >> 48) & 0xFF) ^ p[6]] ^ ecma[0][(reg >> 56) ^ p[7]];
    }
#endif
    for (; i < length; i++) {
        reg = (reg >> 8) ^ ecma[0][(reg & 0xFF) ^ data[i]];
    }
    return reg;
}

#endif

uint64 Crc_CalculateCRC64(const uint8 *Data, uint32 Length, uint64 StartValue,
                          boolean IsFirstCall) {
    return ~run(IsFirstCall ? ~0ULL : ~StartValue, Data, Length);
}
