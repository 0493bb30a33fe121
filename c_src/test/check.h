/* check.h: a failed check prints where and what, and makes the program exit with 1. */
#ifndef CHECK_H
#define CHECK_H

#include <stdio.h>
#include <string.h>

static int check_failures;

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            check_failures++;                                                                      \
            fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, #condition);                        \
        }                                                                                          \
    } while (0)

#define CHECK_INT(expression, expected)                                                            \
    do {                                                                                           \
        long long check_got = (long long)(expression), check_want = (long long)(expected);         \
        if (check_got != check_want) {                                                             \
            check_failures++;                                                                      \
            fprintf(stderr, "%s:%d: %s is %lld, expected %lld\n", __FILE__, __LINE__, #expression, \
                    check_got, check_want);                                                        \
        }                                                                                          \
    } while (0)

/* Same bits: 0 and -0 differ, a NaN equals itself. */
#define CHECK_BITS(expression, expected)                                                           \
    do {                                                                                           \
        double check_got = (expression), check_want = (expected);                                  \
        if (memcmp(&check_got, &check_want, sizeof check_got) != 0) {                              \
            check_failures++;                                                                      \
            fprintf(stderr, "%s:%d: %s is %a, expected %a\n", __FILE__, __LINE__, #expression,     \
                    check_got, check_want);                                                        \
        }                                                                                          \
    } while (0)

#define CHECK_RESULT() (check_failures == 0 ? 0 : 1)

#endif
