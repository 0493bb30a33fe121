/* Parameters as text: which are numbers, and which float each means (by the compiler's own
 * conversion). */
#include "check.h"
#include "fi.h"
#include "fi_replies.h"

#include <stdbool.h>
#include <stdlib.h>

/* Adds SET_TO text; whether it is accepted, then *value and the text of the listing. */
static bool set_to(const char *text, float *value, char *listed) {
    char line[400];
    fi_init();
    fi_run("fi_set_enabled 1");
    snprintf(line, sizeof line, "fi_add_fault p SET_TO %s 0 0", text);
    fi_run(line);
    if (strcmp(fi_last.text, "ok\n") != 0)
        return false;
    fi_inject_fault_float("p", value);
    fi_run("fi_print_faults");
    const char *param = strstr(fi_last.text, "param=");
    return param != NULL && sscanf(param, "param=%63s", listed) == 1;
}

#define MEANS(text, expected, shown)                                                               \
    do {                                                                                           \
        float value = 77;                                                                          \
        char listed[64] = "";                                                                      \
        CHECK(set_to(text, &value, listed));                                                       \
        CHECK_BITS(value, expected);                                                               \
        if (strcmp(listed, shown) != 0) {                                                          \
            check_failures++;                                                                      \
            fprintf(stderr, "%d: %s is listed as %s\n", __LINE__, text, listed);                   \
        }                                                                                          \
    } while (0)

static void numbers(void) {
    MEANS("0", 0.0f, "0");
    MEANS("-0", -0.0f, "-0");
    MEANS("+7", 7.0f, "7");
    MEANS("-7.", -7.0f, "-7");
    MEANS(".5", 0.5f, "0.5");
    MEANS("0.10", 0.1f, "0.10");
    MEANS("3.14159274", 3.14159274f, "3.14159274");
    MEANS("16777217", 16777216.0f, "16777217");
    MEANS("0.3", 0.3f, "0.3");
    MEANS("1e3", 1000.0f, "1e3");
    MEANS("1E+3", 1000.0f, "1e3");
    MEANS("25e-1", 2.5f, "2.5");
    MEANS("0.000000001", 1e-9f, "0.000000001");
    MEANS("1e-10", 1e-10f, "1e-10");
    MEANS("3.40282347e38", 3.40282347e38f, "340282347e30");
    MEANS("340282346638528859811704183484516925440", 3.40282347e38f, "3402823466e29");
    MEANS("1.17549435e-38", 1.17549435e-38f, "117549435e-46");
    MEANS("1e-45", 0x1p-149f, "1e-45");
    MEANS("1e-60", 0.0f, "1e-60");
    MEANS("-1e-99999999999", -0.0f, "-1e-99");
    MEANS("0e99999999999", 0.0f, "0e99");
    MEANS("00000000000000000000000001", 1.0f, "1");
    MEANS("0.00000000000000000000000000000000000000000000000000000000000001e62", 1.0f, "1");
    MEANS("1000000000000000000000000000000000000000000000000000000000000e-60", 1.0f, "1.000000000");
}

static void no_numbers(void) {
    static const char *const texts[] = {"x",
                                        "-",
                                        "+",
                                        ".",
                                        "-.",
                                        "e3",
                                        "1e",
                                        "1e+",
                                        "1e-",
                                        "1.2.3",
                                        "1,5",
                                        "--1",
                                        "+-1",
                                        "1e3.",
                                        "0x10",
                                        "nan",
                                        "inf",
                                        "-inf",
                                        "1f",
                                        "1e3e3",
                                        "1e1000",
                                        "1e39",
                                        "-1e39",
                                        "3.402823568e38",
                                        "999999999999999999999999999999999999999",
                                        "1e99999999999"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        float value = 0;
        char listed[64];
        if (set_to(texts[i], &value, listed)) {
            check_failures++;
            fprintf(stderr, "%s is taken for a number\n", texts[i]);
        }
    }
}

/* Nine digits name every float: the float they are from comes back. */
static void every_float_comes_back(void) {
    unsigned bits = 1;
    for (int i = 0; i < 50000; i++) {
        union {
            unsigned bits;
            float value;
        } given, got;
        char text[64], listed[64];
        bits = bits * 1664525u + 1013904223u;
        given.bits = bits;
        if ((bits >> 23 & 0xff) == 0xff)
            continue;
        snprintf(text, sizeof text, "%.8e", (double)given.value);
        CHECK(set_to(text, &got.value, listed));
        CHECK_INT(got.bits, given.bits);
        CHECK(set_to(listed, &got.value, text));
        CHECK_INT(got.bits, given.bits);
        if (check_failures > 10)
            return;
    }
}

/* Up to ten digits and exponents to +-22 are rounded once in double and once to float. */
static void short_numbers_are_the_nearest_float(void) {
    unsigned random = 7;
    for (int i = 0; i < 50000; i++) {
        char text[64], listed[64];
        float got = 0;
        random = random * 1664525u + 1013904223u;
        snprintf(text, sizeof text, "%u.%02ue%d", random / 4096, random % 100,
                 (int)(random >> 7) % 18);
        CHECK(set_to(text, &got, listed));
        CHECK_BITS(got, strtof(text, NULL));
        if (check_failures > 10)
            return;
    }
}

int main(void) {
    numbers();
    no_numbers();
    every_float_comes_back();
    short_numbers_are_the_nearest_float();
    return CHECK_RESULT();
}
