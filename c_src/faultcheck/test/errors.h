/* errors.h: catches the errors of a context, so that a test can ask for them one by one. */
#ifndef ERRORS_H
#define ERRORS_H

#include "check.h"
#include "fc.h"

static int errors_seen;
static int errors_first; /* of those, met for the first time by their fault */
static int errors_code;
static char errors_text[400];

static void errors_catch(void *user, const fc_error *error) {
    (void)user;
    errors_seen++;
    errors_first += error->first ? 1 : 0;
    errors_code = error->code;
    snprintf(errors_text, sizeof errors_text, "%s", error->text);
}

static void errors_start(fc_context *ctx) {
    fc_set_error_callback(ctx, errors_catch, NULL);
    errors_seen = errors_first = 0;
}

/* Exactly one error since the last question, of that code and with that in its text. */
#define CHECK_ERROR(code, part)                                                                    \
    do {                                                                                           \
        CHECK_INT(errors_seen, 1);                                                                 \
        CHECK_INT(errors_code, code);                                                              \
        CHECK_INT(fc_last_error(), code);                                                          \
        CHECK(strcmp(fc_last_error_text(), errors_text) == 0);                                     \
        if (strstr(errors_text, part) == NULL) {                                                   \
            check_failures++;                                                                      \
            fprintf(stderr, "%s:%d: no \"%s\" in \"%s\"\n", __FILE__, __LINE__, part,              \
                    errors_text);                                                                  \
        }                                                                                          \
        errors_seen = errors_first = 0;                                                            \
    } while (0)

#define CHECK_NO_ERROR() CHECK_INT(errors_seen, 0)

#endif
