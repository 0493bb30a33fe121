/* airbag_sweep.h: every first data byte under one corruption mask, for bounded-exhaustive tests.
 *
 * The packets go the ordinary way: protected, put into the channel, corrupted there by permanent
 * faults, taken out and checked. Only the loop is here, so that ten million cases take seconds. */
#ifndef AIRBAG_SWEEP_H
#define AIRBAG_SWEEP_H

#include "airbag.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What one mask did over the 255 first data bytes other than 85. */
typedef struct {
    int accepted;    /* values of which an altered packet was accepted (status OK, INITIAL, ...) */
    int fired;       /* values that fired the airbag */
    int fired_value; /* the last such value, -1 if there is none */
} airbag_sweep_result;

/* Arm the mask as permanent corruption faults of the channel (byte i of the packet is XORed with
 * mask[i]); then for each value x /= 85: application_init(), and four times sensor_e2e([x,170])
 * followed by an iteration. Removes the channel's faults before and after. */
AIRBAG_API airbag_sweep_result airbag_sweep(const uint8_t *mask);

#ifdef __cplusplus
}
#endif

#endif
