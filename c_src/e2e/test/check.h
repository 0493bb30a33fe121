/* check.h: the smallest test harness. A failed CHECK prints where and what, and the program goes on
 * to the next; check_result() is what main returns. */
#ifndef CHECK_H
#define CHECK_H

#include <stdio.h>

static int check_failures;

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            fprintf(stderr, "%s:%d: not true: %s\n", __FILE__, __LINE__, #condition);              \
            check_failures++;                                                                      \
        }                                                                                          \
    } while (0)

#define CHECK_EQ(expected, actual)                                                                 \
    do {                                                                                           \
        const unsigned long long check_e = (unsigned long long)(expected);                         \
        const unsigned long long check_a = (unsigned long long)(actual);                           \
        if (check_e != check_a) {                                                                  \
            fprintf(stderr, "%s:%d: %s: expected 0x%llx, got 0x%llx\n", __FILE__, __LINE__,        \
                    #actual, check_e, check_a);                                                    \
            check_failures++;                                                                      \
        }                                                                                          \
    } while (0)

static inline int check_result(void) {
    if (check_failures > 0) {
        fprintf(stderr, "%d checks failed\n", check_failures);
    }
    return check_failures > 0;
}

#endif
