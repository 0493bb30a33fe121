/* The packet that profiles 4 and 44 share: Length 2, Counter 2, Data ID 4, CRC32P4 4 bytes. */
#ifndef P04_PACKET_H
#define P04_PACKET_H

#include "Crc.h"
#include "byte_order.h"

#define P04_HEADER 12U
#define P04_COUNTER 2U
#define P04_ID 4U
#define P04_CRC 8U

/* Of all bytes but the four that hold it. */
static inline uint32 P04_Crc(const uint8 *data, uint32 length, uint32 at) {
    const uint32 before = at + P04_CRC;
    const uint32 after = before + 4U;
    const uint32 crc = Crc_CalculateCRC32P4(data, before, 0, TRUE);
    return Crc_CalculateCRC32P4(data + after, length - after, crc, FALSE);
}

static inline uint16 P04_Counter(const uint8 *data, uint32 at) {
    return Get_Be16(data + at + P04_COUNTER);
}

static inline void P04_Write(uint8 *data, uint16 length, uint32 at, uint16 counter, uint32 id) {
    uint8 *header = data + at;
    Put_Be16(header, length);
    Put_Be16(header + P04_COUNTER, counter);
    Put_Be32(header + P04_ID, id);
    Put_Be32(header + P04_CRC, P04_Crc(data, length, at));
}

static inline int P04_IsIntact(const uint8 *data, uint16 length, uint32 at, uint32 id) {
    const uint8 *header = data + at;
    return Get_Be16(header) == length && Get_Be32(header + P04_ID) == id &&
           Get_Be32(header + P04_CRC) == P04_Crc(data, length, at);
}

#endif
