/* The rules that profiles 4, 5, 6, 7, 8, 11, 22 and 44 share (e2e.md section 6).
 *
 * Their status enumerations have the same values under different names; here a status is its
 * number. */
#ifndef CHECK_RULES_H
#define CHECK_RULES_H

#include "E2E.h"

#define STATUS_OK 0x00U
#define STATUS_NONEWDATA 0x01U
#define STATUS_ERROR 0x07U
#define STATUS_REPEATED 0x08U
#define STATUS_OKSOMELOST 0x20U
#define STATUS_WRONGSEQUENCE 0x40U

/* Lengths in bytes, limits in bits; the limits themselves need not be multiples of 8. */
static inline int Length_IsWithin(uint32 length, uint32 min_bits, uint32 max_bits) {
    return length >= min_bits / 8U + (min_bits % 8U != 0) && length <= max_bits / 8U;
}

/* A packet that ends before its header does must be refused before the header is read. */
static inline int Length_HoldsHeader(uint32 length, uint32 offset_bits, uint32 header_bytes) {
    return length >= header_bytes && length - header_bytes >= offset_bits / 8U;
}

/* The verdict on an intact packet whose counter is `delta` ahead of the one before. */
static inline uint32 Sequence_Status(uint32 delta, uint32 max_delta) {
    if (delta > max_delta) {
        return STATUS_WRONGSEQUENCE;
    }
    if (delta == 0) {
        return STATUS_REPEATED;
    }
    return delta == 1 ? STATUS_OK : STATUS_OKSOMELOST;
}

static inline E2E_PCheckStatusType Status_ToSM(Std_ReturnType check_return, uint32 status) {
    if (check_return != E2E_E_OK) {
        return E2E_P_ERROR;
    }
    switch (status) {
    case STATUS_OK:
    case STATUS_OKSOMELOST:
        return E2E_P_OK;
    case STATUS_REPEATED:
        return E2E_P_REPEATED;
    case STATUS_NONEWDATA:
        return E2E_P_NONEWDATA;
    case STATUS_WRONGSEQUENCE:
        return E2E_P_WRONGSEQUENCE;
    default:
        return E2E_P_ERROR;
    }
}

/* What CheckConfig asks of a header at a configurable place and of a range of lengths, all in bits.
 */
static inline int Config_RangeIsSound(uint32 offset, uint32 header_bits, uint32 min, uint32 max,
                                      uint32 upper_limit) {
    return offset % 8U == 0 && min >= header_bits && max >= min && max <= upper_limit &&
           max >= header_bits && max - header_bits >= offset;
}

#endif
