/* check.h: the smallest test aid. A failed CHECK prints itself; main returns check_result(). */
#ifndef CHECK_H
#define CHECK_H

#include <stdio.h>

static int check_failures;

#define CHECK(condition)                                                                           \
    do {                                                                                           \
        if (!(condition)) {                                                                        \
            check_failures++;                                                                      \
            fprintf(stderr, "%s:%d: %s: not true: %s\n", __FILE__, __LINE__, __func__,             \
                    #condition);                                                                   \
        }                                                                                          \
    } while (0)

#define CHECK_INT(expected, actual)                                                                \
    do {                                                                                           \
        long long expected_ = (expected), actual_ = (actual);                                      \
        if (expected_ != actual_) {                                                                \
            check_failures++;                                                                      \
            fprintf(stderr, "%s:%d: %s: %s is %lld, expected %lld\n", __FILE__, __LINE__,          \
                    __func__, #actual, actual_, expected_);                                        \
        }                                                                                          \
    } while (0)

static int check_result(void) {
    return check_failures == 0 ? 0 : 1;
}

#endif
