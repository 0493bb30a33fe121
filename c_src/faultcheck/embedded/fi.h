/* fi.h: fault injection for microcontrollers. This header and fi.c are all of it: C99, no heap, no
 * library but the compiler's own (libgcc); for GCC or clang, IEEE-754 floats and a 32-bit int.
 *
 * Code under test passes values through probes; text lines say which faults they get:
 *
 *     fi_set_enabled 0|1
 *     fi_add_fault <probe_id> <type> <param> <start_it> <duration>
 *     fi_clear_faults | fi_print_faults | fi_reset_cnt
 *
 * probe_id   1 to FI_ID_BYTES bytes
 * type       NONE (any letter case) only counts; BITFLIP flips bit param, truncated and clamped to
 *            0..31; OFFSET adds param; AMPLIFICATION multiplies by it; SET_TO replaces by it.
 * Faults apply in the order of adding. Ints are computed in double, truncated, saturated. param a
 * decimal number within float, as -3, 0.5 or 1e-3; its first nine digits count start_it
 * 0..2147483647: the first affected call, counted from 0 at the moment of adding duration
 * 0..2147483647 calls, 0: for ever
 *
 * A probe counts its calls while injection is enabled and it has a fault. fi_clear_faults removes
 * the faults and frees their probes; the switch stays. fi_reset_cnt sets the counters to 0 but not
 * the numbers of the faults' first calls, so that a fault used up comes again.
 *
 * Threads  One at a time sends lines; one at a time calls the probe of an identifier. They may
 *          interrupt each other: a call sees a fault whole or not at all. Only a call during which
 *          its fault is cleared and another identifier added may be counted for that one.
 * Errors   A command does what it says and replies `ok`, or changes nothing and replies `error`. */
#ifndef FI_H
#define FI_H
#include <stdbool.h>

/* Limits, for the command line. RAM: FI_PROBES * (FI_ID_BYTES + 12 + 20 * FI_FAULTS) + 8 bytes. */
#ifndef FI_PROBES
#define FI_PROBES 5 /* identifiers with faults */
#endif
#ifndef FI_FAULTS
#define FI_FAULTS 5 /* faults of one identifier */
#endif
#ifndef FI_ID_BYTES
#define FI_ID_BYTES 20 /* of the longest identifier */
#endif
#ifdef __cplusplus
extern "C" {
#endif
/* No faults, injection off, as at program start. Not during a call of any other function here. */
void fi_init(void);
/* Whether injection is enabled. */
bool fi_is_active(void);
/* Probes: alter *value as the faults of id say. NULL or an empty id: nothing happens. */
void fi_inject_fault_float(const char *id, float *value);
void fi_inject_fault_int(const char *id, int *value);
/* One command; NULL is none. Words are separated by spaces; line ends count as spaces. reply gets
 * each line of the answer, valid during its call; the last says ok or error. reply may be NULL. */
void fi_process_line(const char *line, void (*reply)(const char *));
#ifdef __cplusplus
}
#endif
#endif
