/* The packet that profiles 2 and 22 share: CRC8H2F 1 byte; low nibble of the next byte the counter.
 */
#ifndef P02_PACKET_H
#define P02_PACKET_H

#include "Crc.h"

#define P02_HEADER 2U
#define P02_COUNTERS 16U
#define P02_MAX_BITS 2048U /* early releases stop at 256 */

/* Of all bytes but the one that holds it, then the Data ID of the counter value sent. */
static inline uint8 P02_Crc(const uint8 *data, uint32 length, uint32 at, uint8 id) {
    uint8 crc = Crc_CalculateCRC8H2F(data, at, 0, TRUE);
    crc = Crc_CalculateCRC8H2F(data + at + 1U, length - at - 1U, crc, FALSE);
    return Crc_CalculateCRC8H2F(&id, 1, crc, FALSE);
}

static inline uint8 P02_Counter(const uint8 *data, uint32 at) {
    return data[at + 1U] & 0x0FU;
}

/* The counter byte's high nibble stays as it is. */
static inline void P02_Write(uint8 *data, uint32 length, uint32 at, uint8 counter,
                             const uint8 *id_list) {
    data[at + 1U] = (uint8)((data[at + 1U] & 0xF0U) | counter);
    data[at] = P02_Crc(data, length, at, id_list[counter]);
}

static inline int P02_IsIntact(const uint8 *data, uint32 length, uint32 at, const uint8 *id_list) {
    return data[at] == P02_Crc(data, length, at, id_list[P02_Counter(data, at)]);
}

#endif
