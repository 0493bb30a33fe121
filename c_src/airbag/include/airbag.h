/* airbag.h: the application under test of Paper I, section 5.
 *
 * A sensor node puts two-byte messages into the packet channel "airbag"; the
 * airbag node takes them out and fires after `needed` messages [85,170] in
 * succession. The functions ending in _e2e protect the same two bytes with
 * AUTOSAR E2E profile 1. The channel belongs to libfaultcheck (the default
 * context), so a test can corrupt, repeat or drop what travels through it.
 *
 * Ownership  nothing is kept of the buffers passed in.
 * Threads    one thread; the state is in globals, as in the original.
 * Output     one line on stdout whenever the airbag fires, as in the original. */
#ifndef AIRBAG_H
#define AIRBAG_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define AIRBAG_API __attribute__((visibility("default")))

/* The name of the packet channel between the two nodes. */
#define AIRBAG_CHANNEL "airbag"

/* What a recording (fc_record_start) has of each packet that the airbag took, behind the packet:
 * the status of E2E_P01Check (-1: it returned an error; nothing for bare packets and wrong
 * lengths), the activation messages counted in succession, and whether the airbag has fired. */
#define AIRBAG_STATUS "airbag_status"
#define AIRBAG_ACTIVATIONS "activations"
#define AIRBAG_FIRED "airbag_fired"

/* How profile 1 is configured.
 *   AIRBAG_THESIS       as in Paper I: DataLength 16, Data ID 0, all states zeroed. The second
 *                       data byte and the counter are outside the CRC.
 *   AIRBAG_RECOMMENDED  DataLength 32, Data ID 0x0123, the library's Init functions. */
typedef enum { AIRBAG_THESIS = 0, AIRBAG_RECOMMENDED = 1 } airbag_variant;

/* How often each outcome of E2E_P01Check was seen; only airbag_clear_statuses() clears it. */
typedef struct {
    uint64_t ok;
    uint64_t no_new_data;
    uint64_t wrong_crc;
    uint64_t sync;
    uint64_t initial;
    uint64_t repeated;
    uint64_t ok_some_lost;
    uint64_t wrong_sequence;
    uint64_t rejected; /* the check returned an error; the status is stale then */
} airbag_statuses;

/* 1 from the moment the airbag fires until application_init(), else 0. */
extern AIRBAG_API int airbag_active;

/* Messages [85,170] counted in succession. */
extern AIRBAG_API int activations;

extern AIRBAG_API airbag_statuses airbag_seen;

/* Choose what the next application_init() sets up. At program start: AIRBAG_THESIS, 2.
 *   needed  messages in succession that fire the airbag, at least 1
 * Returns 0, or -1 and changes nothing when an argument is out of range. */
AIRBAG_API int airbag_configure(airbag_variant variant, int needed);

/* Zero all state of both nodes and set the E2E configuration. Packets in the channel stay. */
AIRBAG_API void application_init(void);

/* The sensor node: put data[0] and data[1] into the channel, bare or as bytes 1 and 2 of a
 * protected packet of 4 bytes. */
AIRBAG_API void sensor(const uint8_t *data);
AIRBAG_API void sensor_e2e(const uint8_t *data);

/* The airbag node: take packets until the channel is empty.
 * Bare: [85,170] counts one up, any other packet sets the count to 0.
 * E2E: the same for packets whose status is OK; packets of any other status change nothing. */
AIRBAG_API void airbag_iteration(void);
AIRBAG_API void airbag_iteration_e2e(void);

/* airbag_active, for callers that can only call functions. */
AIRBAG_API int airbag_is_active(void);

AIRBAG_API void airbag_clear_statuses(void);

/* Median of three sensor values. Each is a probe of its own: S1val, S2val, S3val (Paper I, 4.3). */
AIRBAG_API int sensor_evaluate(int s1, int s2, int s3);

#ifdef __cplusplus
}
#endif

#endif
