/* The packet that profiles 1 and 11 share: where its parts lie and what its CRC covers. */
#ifndef P01_PACKET_H
#define P01_PACKET_H

#include "crc8.h"
#include "nibble.h"

#define P01_COUNTERS 15U /* 0..14; 15 is never sent */

/* The two forms in which the Data ID enters the CRC; the CRC of nothing is 0.
 *
 * The standard starts this CRC at 0 and leaves the result as it is: it has the routine go on from
 * 0xFF and undoes its final XOR. What remains is the bare remainder. */
static inline uint8 P01_IdByte(uint8 byte) {
    return Crc8_Byte(&Crc8_J1850, 0, byte);
}

static inline uint8 P01_IdBytes(uint8 first, uint8 second) {
    return Crc8_Byte(&Crc8_J1850, P01_IdByte(first), second);
}

/* Goes on from the CRC of the Data ID over all data bytes but the one that holds the CRC. */
static inline uint8 P01_Crc(uint8 id_crc, const uint8 *data, uint32 length, uint32 crc_at) {
    const uint32 before = crc_at < length ? crc_at : length;
    const uint8 crc = Crc8_Run(&Crc8_J1850, id_crc, data, before);
    if (crc_at + 1U >= length) {
        return crc;
    }
    return Crc8_Run(&Crc8_J1850, crc, data + crc_at + 1U, length - crc_at - 1U);
}

#endif
