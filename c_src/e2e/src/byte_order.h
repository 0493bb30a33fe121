/* Numbers in a packet, most significant byte first. */
#ifndef BYTE_ORDER_H
#define BYTE_ORDER_H

#include "E2E_Types.h"

static inline void Put_Be16(uint8 *at, uint16 value) {
    at[0] = (uint8)(value >> 8);
    at[1] = (uint8)value;
}

static inline uint16 Get_Be16(const uint8 *at) {
    return (uint16)((at[0] << 8) | at[1]);
}

static inline void Put_Be32(uint8 *at, uint32 value) {
    Put_Be16(at, (uint16)(value >> 16));
    Put_Be16(at + 2, (uint16)value);
}

static inline uint32 Get_Be32(const uint8 *at) {
    return ((uint32)Get_Be16(at) << 16) | Get_Be16(at + 2);
}

static inline void Put_Be64(uint8 *at, uint64 value) {
    Put_Be32(at, (uint32)(value >> 32));
    Put_Be32(at + 4, (uint32)value);
}

static inline uint64 Get_Be64(const uint8 *at) {
    return ((uint64)Get_Be32(at) << 32) | Get_Be32(at + 4);
}

#endif
