/* The checksums against the check values of e2e.md section 2 and against a bit-at-a-time division.
 */
#include "Crc.h"
#include "check.h"

static const uint8 digits[] = "123456789";

static void check_strings_give_the_published_values(void) {
    CHECK_EQ(0x4B, Crc_CalculateCRC8(digits, 9, 0, TRUE));
    CHECK_EQ(0xDF, Crc_CalculateCRC8H2F(digits, 9, 0, TRUE));
    CHECK_EQ(0x29B1, Crc_CalculateCRC16(digits, 9, 0, TRUE));
    CHECK_EQ(0xBB3D, Crc_CalculateCRC16ARC(digits, 9, 0, TRUE));
    CHECK_EQ(0xCBF43926U, Crc_CalculateCRC32(digits, 9, 0, TRUE));
    CHECK_EQ(0x1697D06AU, Crc_CalculateCRC32P4(digits, 9, 0, TRUE));
    CHECK_EQ(0x995DC9BBDF1939FAULL, Crc_CalculateCRC64(digits, 9, 0, TRUE));
}

static void nothing_gives_the_start_value(void) {
    CHECK_EQ(0x00, Crc_CalculateCRC8(NULL, 0, 0x55, TRUE));
    CHECK_EQ(0x00, Crc_CalculateCRC8H2F(NULL, 0, 0x55, TRUE));
    CHECK_EQ(0xFFFF, Crc_CalculateCRC16(NULL, 0, 0x55, TRUE));
    CHECK_EQ(0x0000, Crc_CalculateCRC16ARC(NULL, 0, 0x55, TRUE));
    CHECK_EQ(0, Crc_CalculateCRC32(NULL, 0, 0x55, TRUE));
    CHECK_EQ(0, Crc_CalculateCRC32P4(NULL, 0, 0x55, TRUE));
    CHECK_EQ(0, Crc_CalculateCRC64(NULL, 0, 0x55, TRUE));
    CHECK_EQ(0x55, Crc_CalculateCRC8(NULL, 0, 0x55, FALSE));
    CHECK_EQ(0x5555, Crc_CalculateCRC16(NULL, 0, 0x5555, FALSE));
    CHECK_EQ(0x55555555U, Crc_CalculateCRC32P4(NULL, 0, 0x55555555U, FALSE));
    CHECK_EQ(0x5555555555555555ULL, Crc_CalculateCRC64(NULL, 0, 0x5555555555555555ULL, FALSE));
}

/* Long division on paper: most significant bit first, width up to 64. */
static uint64 divide(int width, uint64 polynomial, uint64 reg, const uint8 *data, uint32 length) {
    const uint64 top = 1ULL << (width - 1);
    for (uint32 i = 0; i < length * 8; i++) {
        const int bit = (data[i / 8] >> (7 - i % 8)) & 1;
        const int out = (reg & top) != 0;
        reg = (reg << 1) ^ ((bit != out) ? polynomial : 0);
    }
    return width == 64 ? reg : reg & ((1ULL << width) - 1);
}

static uint64 mirror(int width, uint64 value) {
    uint64 mirrored = 0;
    for (int bit = 0; bit < width; bit++) {
        mirrored |= ((value >> bit) & 1) << (width - 1 - bit);
    }
    return mirrored;
}

/* The same with each byte's bits and the result's mirrored. */
static uint64 divide_reflected(int width, uint64 polynomial, uint64 reg, const uint8 *data,
                               uint32 length) {
    uint8 mirrored[80];
    for (uint32 i = 0; i < length; i++) {
        mirrored[i] = (uint8)mirror(8, data[i]);
    }
    return mirror(width, divide(width, polynomial, reg, mirrored, length));
}

/* Lengths around the step of eight, at every alignment, split at every place. */
static void every_length_and_split_agrees_with_long_division(void) {
    uint8 data[80];
    for (uint32 i = 0; i < sizeof data; i++) {
        data[i] = (uint8)(i * 37 + (i >> 2) * 11 + 5);
    }
    for (uint32 n = 0; n <= 40; n++) {
        const uint8 *d = data + n % 9;
        for (uint32 cut = 0; cut <= n; cut += 3) {
            const uint8 *e = d + cut;
            const uint32 m = n - cut;
            CHECK_EQ(divide(8, 0x1D, 0xFF, d, n) ^ 0xFF,
                     Crc_CalculateCRC8(e, m, Crc_CalculateCRC8(d, cut, 0, TRUE), FALSE));
            CHECK_EQ(divide(8, 0x2F, 0xFF, d, n) ^ 0xFF,
                     Crc_CalculateCRC8H2F(e, m, Crc_CalculateCRC8H2F(d, cut, 0, TRUE), FALSE));
            CHECK_EQ(divide(16, 0x1021, 0xFFFF, d, n),
                     Crc_CalculateCRC16(e, m, Crc_CalculateCRC16(d, cut, 0, TRUE), FALSE));
            CHECK_EQ(divide_reflected(16, 0x8005, 0, d, n),
                     Crc_CalculateCRC16ARC(e, m, Crc_CalculateCRC16ARC(d, cut, 0, TRUE), FALSE));
            CHECK_EQ(divide_reflected(32, 0x04C11DB7, 0xFFFFFFFF, d, n) ^ 0xFFFFFFFF,
                     Crc_CalculateCRC32(e, m, Crc_CalculateCRC32(d, cut, 0, TRUE), FALSE));
            CHECK_EQ(divide_reflected(32, 0xF4ACFB13, 0xFFFFFFFF, d, n) ^ 0xFFFFFFFF,
                     Crc_CalculateCRC32P4(e, m, Crc_CalculateCRC32P4(d, cut, 0, TRUE), FALSE));
            CHECK_EQ(~divide_reflected(64, 0x42F0E1EBA9EA3693, ~0ULL, d, n),
                     Crc_CalculateCRC64(e, m, Crc_CalculateCRC64(d, cut, 0, TRUE), FALSE));
        }
    }
}

int main(void) {
    check_strings_give_the_published_values();
    nothing_gives_the_start_value();
    every_length_and_split_agrees_with_long_division();
    return check_result();
}
