/* The bound the benchmark compares with: protect and check written down with nothing but a
 * 256-entry table, a byte at a time, no argument checks, no configuration, everything inlined into
 * the measuring loop. */
#ifndef TABLE_BOUND_H
#define TABLE_BOUND_H

#include <stdint.h>

typedef struct {
    uint8_t crc8[256];   /* polynomial 0x1D */
    uint32_t crc32[256]; /* 0xF4ACFB13, reflected */
    uint64_t crc64[256]; /* 0x42F0E1EBA9EA3693, reflected */
} BoundTables;

static inline void bound_fill(BoundTables *t) {
    for (unsigned i = 0; i < 256; i++) {
        uint8_t r8 = (uint8_t)i;
        uint32_t r32 = i;
        uint64_t r64 = i;
        for (int bit = 0; bit < 8; bit++) {
            r8 = (uint8_t)((r8 << 1) ^ ((r8 & 0x80) ? 0x1D : 0));
            r32 = (r32 >> 1) ^ ((r32 & 1) ? 0xC8DF352FU : 0);
            r64 = (r64 >> 1) ^ ((r64 & 1) ? 0xC96C5795D7870F42ULL : 0);
        }
        t->crc8[i] = r8;
        t->crc32[i] = r32;
        t->crc64[i] = r64;
    }
}

static inline void bound_put(uint8_t *at, uint64_t value, int bytes) {
    for (int i = 0; i < bytes; i++) {
        at[i] = (uint8_t)(value >> (8 * (bytes - 1 - i)));
    }
}

static inline uint64_t bound_get(const uint8_t *at, int bytes) {
    uint64_t value = 0;
    for (int i = 0; i < bytes; i++) {
        value = value << 8 | at[i];
    }
    return value;
}

/* Profile 1, BOTH: CRC in byte 0, counter in byte 1. */
static inline uint8_t bound_p01_crc(const BoundTables *t, uint16_t id, const uint8_t *d, int n) {
    uint8_t crc = t->crc8[id & 0xFF];
    crc = t->crc8[crc ^ (id >> 8)];
    for (int i = 1; i < n; i++) {
        crc = t->crc8[crc ^ d[i]];
    }
    return crc;
}

static inline void bound_p01_protect(const BoundTables *t, uint16_t id, uint8_t *counter,
                                     uint8_t *d, int n) {
    d[1] = (uint8_t)((d[1] & 0xF0) | *counter);
    d[0] = bound_p01_crc(t, id, d, n);
    *counter = (uint8_t)(*counter == 14 ? 0 : *counter + 1);
}

static inline int bound_p01_check(const BoundTables *t, uint16_t id, uint8_t *last,
                                  const uint8_t *d, int n) {
    const uint8_t received = d[1] & 0x0F;
    if (received > 14 || d[0] != bound_p01_crc(t, id, d, n)) {
        return 0;
    }
    const int delta = received >= *last ? received - *last : received + 15 - *last;
    *last = received;
    return delta == 1;
}

/* Profile 4: Length 2, Counter 2, Data ID 4, CRC 4. */
static inline uint32_t bound_p04_crc(const BoundTables *t, const uint8_t *d, int n) {
    uint32_t crc = ~0U;
    for (int i = 0; i < 8; i++) {
        crc = (crc >> 8) ^ t->crc32[(crc ^ d[i]) & 0xFF];
    }
    for (int i = 12; i < n; i++) {
        crc = (crc >> 8) ^ t->crc32[(crc ^ d[i]) & 0xFF];
    }
    return ~crc;
}

static inline void bound_p04_protect(const BoundTables *t, uint32_t id, uint16_t *counter,
                                     uint8_t *d, int n) {
    bound_put(d, (uint64_t)n, 2);
    bound_put(d + 2, (*counter)++, 2);
    bound_put(d + 4, id, 4);
    bound_put(d + 8, bound_p04_crc(t, d, n), 4);
}

static inline int bound_p04_check(const BoundTables *t, uint32_t id, uint16_t *last,
                                  const uint8_t *d, int n) {
    const uint16_t received = (uint16_t)bound_get(d + 2, 2);
    const int good = bound_get(d, 2) == (uint64_t)n && bound_get(d + 4, 4) == id &&
                     bound_get(d + 8, 4) == bound_p04_crc(t, d, n) &&
                     (uint16_t)(received - *last) == 1;
    *last = received;
    return good;
}

/* Profile 7: CRC 8, Length 4, Counter 4, Data ID 4. */
static inline uint64_t bound_p07_crc(const BoundTables *t, const uint8_t *d, int n) {
    uint64_t crc = ~0ULL;
    for (int i = 8; i < n; i++) {
        crc = (crc >> 8) ^ t->crc64[(crc ^ d[i]) & 0xFF];
    }
    return ~crc;
}

static inline void bound_p07_protect(const BoundTables *t, uint32_t id, uint32_t *counter,
                                     uint8_t *d, int n) {
    bound_put(d + 8, (uint64_t)n, 4);
    bound_put(d + 12, (*counter)++, 4);
    bound_put(d + 16, id, 4);
    bound_put(d, bound_p07_crc(t, d, n), 8);
}

static inline int bound_p07_check(const BoundTables *t, uint32_t id, uint32_t *last,
                                  const uint8_t *d, int n) {
    const uint32_t received = (uint32_t)bound_get(d + 12, 4);
    const int good = bound_get(d + 8, 4) == (uint64_t)n && bound_get(d + 16, 4) == id &&
                     bound_get(d, 8) == bound_p07_crc(t, d, n) && received - *last == 1;
    *last = received;
    return good;
}

#endif
