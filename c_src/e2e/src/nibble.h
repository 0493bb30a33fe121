/* A nibble of a packet, addressed by a bit offset that is a multiple of 4. */
#ifndef NIBBLE_H
#define NIBBLE_H

#include "E2E_Types.h"

static inline uint8 Nibble_Read(const uint8 *data, uint32 bit_offset) {
    return (uint8)((data[bit_offset >> 3] >> (bit_offset & 4U)) & 0x0FU);
}

/* The byte's other nibble stays as it is. */
static inline void Nibble_Write(uint8 *data, uint32 bit_offset, uint8 value) {
    const uint32 shift = bit_offset & 4U;
    uint8 *byte = &data[bit_offset >> 3];
    *byte = (uint8)((*byte & (0xF0U >> shift)) | ((value & 0x0FU) << shift));
}

#endif
