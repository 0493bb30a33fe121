/* How the checksums are computed, chosen when the library is built: -DE2E_CRC_METHOD=...
 *
 *   method             constant data   speed
 *   E2E_CRC_BITWISE    none            8 steps a byte
 *   E2E_CRC_TABLE      5.5 KiB         one look-up a byte, each waits for the one before
 *   E2E_CRC_SLICED     44 KiB          eight bytes a step, their look-ups independent
 *
 * A linker that drops unused sections (-fdata-sections, --gc-sections) keeps only the tables in
 * use.
 *
 * A table entry is linear over GF(2): the entry of a byte is the XOR of the entries of its bits. So
 * a row of 256 entries is spelt by the compiler out of eight numbers, the remainders of eight
 * successive powers of x, and a polynomial is described by the 64 powers x^w .. x^(w+63), w being
 * its width. Rows are written from the entry of bit 0 to that of bit 7. Row k holds the effect of a
 * byte followed by k more bytes. */
#ifndef CRC_METHOD_H
#define CRC_METHOD_H

#include "E2E_Types.h"

#define E2E_CRC_BITWISE 0
#define E2E_CRC_TABLE 1
#define E2E_CRC_SLICED 2

#ifndef E2E_CRC_METHOD
#define E2E_CRC_METHOD E2E_CRC_TABLE
#endif

/* Shared between files of the library, not with its users. */
#if defined(__GNUC__)
#define E2E_LOCAL __attribute__((visibility("hidden")))
#else
#define E2E_LOCAL
#endif

#define CRC_2(v, b0) v, v ^ b0
#define CRC_4(v, b0, b1) CRC_2(v, b0), CRC_2(v ^ b1, b0)
#define CRC_8(v, b0, b1, b2) CRC_4(v, b0, b1), CRC_4(v ^ b2, b0, b1)
#define CRC_16(v, b0, b1, b2, b3) CRC_8(v, b0, b1, b2), CRC_8(v ^ b3, b0, b1, b2)
#define CRC_32(v, b0, b1, b2, b3, b4) CRC_16(v, b0, b1, b2, b3), CRC_16(v ^ b4, b0, b1, b2, b3)
#define CRC_64(v, b0, b1, b2, b3, b4, b5)                                                          \
    CRC_32(v, b0, b1, b2, b3, b4), CRC_32(v ^ b5, b0, b1, b2, b3, b4)
#define CRC_128(v, b0, b1, b2, b3, b4, b5, b6)                                                     \
    CRC_64(v, b0, b1, b2, b3, b4, b5), CRC_64(v ^ b6, b0, b1, b2, b3, b4, b5)
#define CRC_ROW(b0, b1, b2, b3, b4, b5, b6, b7)                                                    \
    { CRC_128(0, b0, b1, b2, b3, b4, b5, b6), CRC_128(b7, b0, b1, b2, b3, b4, b5, b6) }

#if E2E_CRC_METHOD == E2E_CRC_SLICED
#define CRC_ROWS 8
#define CRC_TABLE(r0, r1, r2, r3, r4, r5, r6, r7)                                                  \
    {                                                                                              \
        CRC_ROW r0, CRC_ROW r1, CRC_ROW r2, CRC_ROW r3, CRC_ROW r4, CRC_ROW r5, CRC_ROW r6,        \
            CRC_ROW r7                                                                             \
    }
#else
#define CRC_ROWS 1
#define CRC_TABLE(r0, ...)                                                                         \
    { CRC_ROW r0 }
#endif

#endif
