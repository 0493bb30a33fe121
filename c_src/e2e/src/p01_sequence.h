/* What a valid packet's counter means to profiles 1 and 2: one set of rules, two counter ranges.
 *
 * The public state types differ by profile, so the caller copies its members into `Progress` and
 * back; inlined, nothing of that remains. */
#ifndef P01_SEQUENCE_H
#define P01_SEQUENCE_H

#include "E2E_P01.h"

typedef struct {
    uint8 counters; /* how many counter values there are; their differences are taken modulo this */
    uint8 max_delta_init;
    uint8 max_no_new_or_repeated;
    uint8 sync_init;
} Limits;

typedef struct {
    uint8 last_valid;
    uint8 max_delta;
    uint8 lost;
    uint8 sync;
    uint8 no_new_or_repeated;
} Progress;

/* Counts one up and stays at the largest counter value. */
static inline uint8 P01_CountUp(uint8 count, uint8 counters) {
    return (uint8)(count < counters - 1 ? count + 1 : count);
}

static inline void P01_StartOver(const Limits *limits, Progress *p) {
    p->no_new_or_repeated = 0;
    p->sync = limits->sync_init;
}

static inline E2E_P01CheckStatusType P01_InSequence(const Limits *limits, Progress *p,
                                                    uint8 received, uint8 delta) {
    p->max_delta = limits->max_delta_init;
    p->last_valid = received;
    p->lost = (uint8)(delta - 1);
    if (p->no_new_or_repeated > limits->max_no_new_or_repeated) {
        P01_StartOver(limits, p);
        return E2E_P01STATUS_SYNC;
    }
    p->no_new_or_repeated = 0;
    if (p->sync > 0) {
        p->sync--;
        return E2E_P01STATUS_SYNC;
    }
    return delta == 1 ? E2E_P01STATUS_OK : E2E_P01STATUS_OKSOMELOST;
}

static inline E2E_P01CheckStatusType P01_OutOfSequence(const Limits *limits, Progress *p,
                                                       uint8 received) {
    P01_StartOver(limits, p);
    if (p->sync > 0) {
        p->max_delta = limits->max_delta_init;
        p->last_valid = received;
    }
    return E2E_P01STATUS_WRONGSEQUENCE;
}

static inline E2E_P01CheckStatusType P01_Sequence(const Limits *limits, Progress *p,
                                                  uint8 received) {
    const uint8 last = (uint8)(p->last_valid % limits->counters);
    const uint8 delta =
        (uint8)(received >= last ? received - last : received + limits->counters - last);
    if (delta == 0) {
        p->no_new_or_repeated = P01_CountUp(p->no_new_or_repeated, limits->counters);
        return E2E_P01STATUS_REPEATED;
    }
    return delta <= p->max_delta ? P01_InSequence(limits, p, received, delta)
                                 : P01_OutOfSequence(limits, p, received);
}

static inline E2E_PCheckStatusType
P01_ToSM(Std_ReturnType check_return, E2E_P01CheckStatusType status, boolean as_later_profiles) {
    if (check_return != E2E_E_OK) {
        return E2E_P_ERROR;
    }
    switch (status) {
    case E2E_P01STATUS_OK:
    case E2E_P01STATUS_OKSOMELOST:
        return E2E_P_OK;
    case E2E_P01STATUS_SYNC:
        return as_later_profiles ? E2E_P_OK : E2E_P_WRONGSEQUENCE;
    case E2E_P01STATUS_INITIAL:
        return as_later_profiles ? E2E_P_WRONGSEQUENCE : E2E_P_OK;
    case E2E_P01STATUS_NONEWDATA:
        return E2E_P_NONEWDATA;
    case E2E_P01STATUS_REPEATED:
        return E2E_P_REPEATED;
    case E2E_P01STATUS_WRONGSEQUENCE:
        return E2E_P_WRONGSEQUENCE;
    case E2E_P01STATUS_WRONGCRC:
        break;
    }
    return E2E_P_ERROR;
}

#endif
