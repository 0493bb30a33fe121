/* CRC32 (Ethernet) and CRC32P4: reflected, start and final XOR all ones. */
#include "Crc.h"
#include "crc_method.h"

#if E2E_CRC_METHOD == E2E_CRC_BITWISE

typedef uint32 divisor; /* the polynomial, reflected */
static const divisor ethernet = 0xEDB88320U;
static const divisor p4 = 0xC8DF352FU;

static uint32 run(const divisor *poly, uint32 reg, const uint8 *data, uint32 length) {
    for (uint32 i = 0; i < length; i++) {
        reg ^= data[i];
        for (int bit = 0; bit < 8; bit++) {
            reg = (reg >> 1) ^ ((reg & 1U) ? *poly : 0U);
        }
    }
    return reg;
}

#else

typedef struct {
    uint32 row[CRC_ROWS][256];
} divisor;

static const divisor ethernet = {CRC_TABLE((0x77073096U, 0xee0e612cU, 0x076dc419U, 0x0edb8832U,
                                            0x1db71064U, 0x3b6e20c8U, 0x76dc4190U, 0xedb88320U),
                                           (0x191b3141U, 0x32366282U, 0x646cc504U, 0xc8d98a08U,
                                            0x4ac21251U, 0x958424a2U, 0xf0794f05U, 0x3b83984bU),
                                           (0x01c26a37U, 0x0384d46eU, 0x0709a8dcU, 0x0e1351b8U,
                                            0x1c26a370U, 0x384d46e0U, 0x709a8dc0U, 0xe1351b80U),
                                           (0xb8bc6765U, 0xaa09c88bU, 0x8f629757U, 0xc5b428efU,
                                            0x5019579fU, 0xa032af3eU, 0x9b14583dU, 0xed59b63bU),
                                           (0x3d6029b0U, 0x7ac05360U, 0xf580a6c0U, 0x30704bc1U,
                                            0x60e09782U, 0xc1c12f04U, 0x58f35849U, 0xb1e6b092U),
                                           (0xcb5cd3a5U, 0x4dc8a10bU, 0x9b914216U, 0xec53826dU,
                                            0x03d6029bU, 0x07ac0536U, 0x0f580a6cU, 0x1eb014d8U),
                                           (0xa6770bb4U, 0x979f1129U, 0xf44f2413U, 0x33ef4e67U,
                                            0x67de9cceU, 0xcfbd399cU, 0x440b7579U, 0x8816eaf2U),
                                           (0xccaa009eU, 0x4225077dU, 0x844a0efaU, 0xd3e51bb5U,
                                            0x7cbb312bU, 0xf9766256U, 0x299dc2edU, 0x533b85daU))};

static const divisor p4 = {CRC_TABLE((0x30850ff5U, 0x610a1feaU, 0xc2143fd4U, 0x159615f7U,
                                      0x2b2c2beeU, 0x565857dcU, 0xacb0afb8U, 0xc8df352fU),
                                     (0xebba538bU, 0x46cacd49U, 0x8d959a92U, 0x8a955f7bU,
                                      0x8494d4a9U, 0x9897c30dU, 0xa091ec45U, 0xd09db2d5U),
                                     (0x8c2d8a94U, 0x89e57f77U, 0x827494b1U, 0x9557433dU,
                                      0xbb10ec25U, 0xe79fb215U, 0x5e810e75U, 0xbd021ceaU),
                                     (0x216b0c9fU, 0x42d6193eU, 0x85ac327cU, 0x9ae60ea7U,
                                      0xa4727711U, 0xd95a847dU, 0x230b62a5U, 0x4616c54aU),
                                     (0x65df4ff1U, 0xcbbe9fe2U, 0x06c3559bU, 0x0d86ab36U,
                                      0x1b0d566cU, 0x361aacd8U, 0x6c3559b0U, 0xd86ab360U),
                                     (0x29fb361fU, 0x53f66c3eU, 0xa7ecd87cU, 0xde67daa7U,
                                      0x2d71df11U, 0x5ae3be22U, 0xb5c77c44U, 0xfa3092d7U),
                                     (0xad08eae4U, 0xcbafbf97U, 0x06e11571U, 0x0dc22ae2U,
                                      0x1b8455c4U, 0x3708ab88U, 0x6e115710U, 0xdc22ae20U),
                                     (0xf08efa75U, 0x70a39eb5U, 0xe1473d6aU, 0x5330108bU,
                                      0xa6602116U, 0xdd7e2873U, 0x2b423ab9U, 0x56847572U))};

static uint32 run(const divisor *t, uint32 reg, const uint8 *data, uint32 length) {
    uint32 i = 0;
#if E2E_CRC_METHOD == E2E_CRC_SLICED
    for (; length - i >= 8; i += 8) {
        const uint8 *p = data + i;
        reg = t->row[7][(reg & 0xFF) ^ p[0]] ^ t->row[6][((reg >> 8) & 0xFF) ^ p[1]] ^
              t->row[5][((reg >> 16) & 0xFF) ^ p[2]] ^ t->row[4][(reg >> 24) ^ p[3]] ^
              t->row[3][p[4]] ^ t->row[2][p[5]] ^ t->row[1][p[6]] ^ t->row[0][p[7]];
    }
#endif
    for (; i < length; i++) {
        reg = (reg >> 8) ^ t->row[0][(reg & 0xFF) ^ data[i]];
    }
    return reg;
}

#endif

static uint32 calculate(const divisor *by, const uint8 *data, uint32 length, uint32 start,
                        boolean first) {
    return ~run(by, first ? 0xFFFFFFFFU : ~start, data, length);
}

uint32 Crc_CalculateCRC32(const uint8 *Data, uint32 Length, uint32 StartValue,
                          boolean IsFirstCall) {
    return calculate(&ethernet, Data, Length, StartValue, IsFirstCall);
}

uint32 Crc_CalculateCRC32P4(const uint8 *Data, uint32 Length, uint32 StartValue,
                            boolean IsFirstCall) {
    return calculate(&p4, Data, Length, StartValue, IsFirstCall);
}
