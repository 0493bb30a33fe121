/* fc_named.h: faults by the names of their models and parameters, for readers of text. Part of
 * fc.h. docs/faults.md lists them. */
#ifndef FC_NAMED_H
#define FC_NAMED_H

#include "fc_context.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What kind of value a parameter takes. */
typedef enum {
    FC_TAKES_NUMBER, /* any number; also the texts "inf", "-inf" and "nan" */
    FC_TAKES_WHOLE,  /* a whole number of at most 2^53 */
    FC_TAKES_TEXT    /* a text, as fc_parameter says */
} fc_takes;

/* A parameter of a model. */
typedef struct {
    const char *name;  /* "value", "low" ... */
    const char *other; /* more names that mean the same, between commas; or NULL */
    fc_takes takes;    /* what kind of value */
    bool required;     /* or has a value of its own */
    const char *text;  /* one line: what it is, and the value when it is left out */
} fc_parameter;

/* The names of all models of probes, or of channels: the index-th from 0, or NULL. */
FC_API const char *fc_model_name(bool of_channels, int index);

/* The parameters of a model: the index-th from 0, or NULL; also NULL for an unknown model. */
FC_API const fc_parameter *fc_model_parameter(bool of_channels, const char *model, int index);

/* A parameter with its value. */
typedef struct {
    const char *name; /* of the parameter */
    const char *text; /* NULL: the value is the number */
    double number;    /* the value, when text is NULL */
} fc_argument;

/* Arm a fault on a probe or a channel. A fault id, or as the fc_add_ or fc_channel_add_ function of
 * the model; FC_E_ARG for an unknown model, an unknown or repeated parameter, one that is missing,
 * or one of the wrong kind: fc_last_error_text() names it and says what would be right. */
FC_API fc_fault_id fc_arm_named(fc_context *ctx, const char *id, const char *model,
                                const fc_argument *arguments, size_t count);
FC_API fc_fault_id fc_channel_arm_named(fc_context *ctx, const char *channel, const char *model,
                                        const fc_argument *arguments, size_t count);

#ifdef __cplusplus
}
#endif

#endif
