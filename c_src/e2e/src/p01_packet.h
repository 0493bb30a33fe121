/* The packet that profiles 1 and 11 share: where its parts lie and what its CRC covers. */
#ifndef P01_PACKET_H
#define P01_PACKET_H

#include "Crc.h"
#include "nibble.h"

#define P01_COUNTERS 15U /* 0..14; 15 is never sent */

/* CRC of the Data ID bytes given and of all data bytes but the one that holds the CRC.
 *
 * The standard starts this CRC at 0 and leaves the result as it is: the routine is told to go on
 * from 0xFF and its final XOR is undone. */
static inline uint8 P01_Crc(const uint8 *id, uint32 id_length, const uint8 *data, uint32 length,
                            uint32 crc_at) {
    const uint32 before = crc_at < length ? crc_at : length;
    uint8 crc = Crc_CalculateCRC8(id, id_length, 0xFF, FALSE);
    crc = Crc_CalculateCRC8(data, before, crc, FALSE);
    if (crc_at + 1U < length) {
        crc = Crc_CalculateCRC8(data + crc_at + 1U, length - crc_at - 1U, crc, FALSE);
    }
    return (uint8)(crc ^ 0xFF);
}

#endif
