/* Faults armed by the names of models and parameters: fc_named.h. */
#include "errors.h"

#include <math.h>

static fc_context *ctx;

static void start(void) {
    ctx = fc_new(NULL);
    errors_start(ctx);
}

static void finish(void) {
    CHECK_NO_ERROR();
    fc_free(ctx);
}

/* The fault armed last, as listed. */
static fc_listed_fault last;

static void see(void *user, const fc_listed *listed) {
    (void)user;
    for (size_t at = 0; at < listed->fault_count; at++)
        if (listed->faults[at].id >= last.id)
            last = listed->faults[at];
}

static void look(void) {
    memset(&last, 0, sizeof last);
    fc_list(ctx, see, NULL);
}

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* Model, then its arguments; as fc_model. */
static const struct {
    const char *model;
    fc_argument arguments[3];
    fc_model is;
} values[] = {
    {"bitflip", {{"bit", NULL, 7}}, {FC_BITFLIP, 0, 0, 7}},
    {"bitflip_random", {{NULL, NULL, 0}}, {FC_BITFLIP_RANDOM, 0, 0, 0}},
    {"stuck", {{NULL, NULL, 0}}, {FC_STUCK, 0, 0, 0}},
    {"stuck_to_current", {{NULL, NULL, 0}}, {FC_STUCK, 0, 0, 0}},
    {"stuck_bit", {{"value", NULL, 1}, {"bit", NULL, 3}}, {FC_STUCK_BIT, 1, 0, 3}},
    {"amplification", {{"value", NULL, 0.95}}, {FC_AMPLIFICATION, 0.95, 0, 0}},
    {"amplification", {{"factor", NULL, 0.95}}, {FC_AMPLIFICATION, 0.95, 0, 0}},
    {"offset", {{"value", NULL, -3.5}}, {FC_OFFSET, -3.5, 0, 0}},
    {"offset", {{"constant", NULL, 2}}, {FC_OFFSET, 2, 0, 0}},
    {"offset", {{"c", NULL, 2}}, {FC_OFFSET, 2, 0, 0}},
    {"set_to", {{"value", NULL, 1e300}}, {FC_SET_TO, 1e300, 0, 0}},
    {"set_to", {{"value", "nan", 0}}, {FC_SET_TO, NAN, 0, 0}},
    {"saturate", {{"low", "-inf", 0}, {"high", "inf", 0}}, {FC_SATURATE, -HUGE_VAL, HUGE_VAL, 0}},
    {"noise_uniform", {{"amplitude", NULL, 2}}, {FC_NOISE_UNIFORM, 2, 0, 0}},
    {"noise_gauss", {{"s", NULL, 1}}, {FC_NOISE_GAUSS, 1, 0, 0}},
    {"random_offset", {{"low", NULL, 0.5}, {"high", NULL, 8}}, {FC_RANDOM_OFFSET, 0.5, 8, 0}},
    {"random_offset", {{"hi", NULL, 8}, {"lo", NULL, 0.5}}, {FC_RANDOM_OFFSET, 0.5, 8, 0}},
    {"drift", {{"rate", NULL, 0.1}, {"limit", NULL, 5}}, {FC_DRIFT, 0.1, 5, 0}},
    {"drift_timed", {{"rate", NULL, 0.1}}, {FC_DRIFT_TIMED, 0.1, HUGE_VAL, 0}},
    {"ramp", {{"value", NULL, 9}, {"calls", NULL, 4}}, {FC_RAMP, 9, 0, 4}},
    {"delay", {{"calls", NULL, 4}}, {FC_DELAY, 0, 0, 4}},
    {"quantise", {{"step", NULL, 0.25}}, {FC_QUANTISE, 0.25, 0, 0}},
    {"dead_zone", {{"centre", NULL, 1}, {"width", NULL, 2}}, {FC_DEAD_ZONE, 1, 2, 0}},
    {"saturate", {{"low", NULL, -1}, {"high", NULL, 1}}, {FC_SATURATE, -1, 1, 0}},
    {"oscillate", {{"amplitude", NULL, 3}, {"calls", NULL, 8}}, {FC_OSCILLATE, 3, 0, 8}},
    {"dropout", {{"probability", NULL, 0.5}, {"mode", "zero", 0}}, {FC_DROPOUT, 0.5, 0, FC_ZERO}},
    {"held_offset",
     {{"low", NULL, -4}, {"high", NULL, 4}, {"ns", NULL, 2e8}},
     {FC_HELD_OFFSET, -4, 4, 200000000}},
    {"spike", {{"probability", NULL, 0.1}, {"height", NULL, 7}}, {FC_SPIKE, 0.1, 7, 0}},
};

static size_t given(const fc_argument *arguments) {
    size_t count = 0;
    while (count < 3 && arguments[count].name != NULL)
        count++;
    return count;
}

static void every_model_of_a_probe_has_a_name(void) {
    start();
    bool met[40] = {false};
    for (size_t at = 0; at < COUNT(values); at++) {
        const fc_argument *arguments = values[at].arguments;
        const fc_fault_id fault =
            fc_arm_named(ctx, "p", values[at].model, arguments, given(arguments));
        CHECK(fault > 0);
        look();
        CHECK_INT(last.id, fault);
        CHECK(strcmp(last.model, fc_model_name(false, values[at].is.kind)) == 0);
        CHECK_BITS(last.a, values[at].is.a);
        CHECK_BITS(last.b, values[at].is.b);
        CHECK_INT(last.n, values[at].is.n);
        met[values[at].is.kind] = true;
    }
    for (int kind = 0; fc_model_name(false, kind) != NULL; kind++)
        CHECK(met[kind]);
    finish();
}

static int arm(const char *model, const char *name, double number) {
    const fc_argument argument = {name, NULL, number};
    return fc_arm_named(ctx, "p", model, &argument, 1) > 0;
}

static void what_does_not_fit_is_refused_by_name(void) {
    start();
    CHECK(!arm("offest", "value", 1));
    CHECK_ERROR(FC_E_ARG, "probe \"p\": there is no model \"offest\" of probes");
    CHECK(!arm("drop", "count", 1));
    CHECK_ERROR(FC_E_ARG, "no model \"drop\" of probes");
    CHECK(!arm(NULL, "value", 1));
    CHECK_ERROR(FC_E_ARG, "no model");
    CHECK(!arm("random_offset", "value", 1));
    CHECK_ERROR(FC_E_ARG, "model random_offset has no parameter \"value\", but low, high");
    const char *const near_misses[] = {"constant,c", "constant,", "", ",", "con", "cc"};
    for (size_t at = 0; at < COUNT(near_misses); at++) {
        CHECK(!arm("offset", near_misses[at], 1));
        CHECK_ERROR(FC_E_ARG, "model offset has no parameter");
    }
    CHECK(!arm("stuck", "value", 1));
    CHECK_ERROR(FC_E_ARG, "model stuck has no parameter \"value\"");
    CHECK(!arm("random_offset", "low", 1));
    CHECK_ERROR(FC_E_ARG, "model random_offset needs high: the upper limit");
    CHECK(!arm("bitflip", "bit", 1.5));
    CHECK_ERROR(FC_E_ARG, "bit must be a whole number");
    CHECK(!arm("bitflip", "bit", NAN));
    CHECK_ERROR(FC_E_ARG, "bit must be a whole number");
    CHECK(!arm("bitflip", "bit", 1e300));
    CHECK_ERROR(FC_E_ARG, "bit must be a whole number");
    CHECK(!arm("bitflip", "bit", -1));
    CHECK_ERROR(FC_E_BIT, "the bit is below 0");
    const fc_argument twice[] = {{"low", NULL, 1}, {"lo", NULL, 2}, {"high", NULL, 3}};
    CHECK_INT(fc_arm_named(ctx, "p", "saturate", twice, 3), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "low is given twice");
    const fc_argument text = {"value", "5", 5};
    CHECK_INT(fc_arm_named(ctx, "p", "offset", &text, 1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "value must be a number, inf, -inf or nan");
    const fc_argument mode[] = {{"probability", NULL, 1}, {"mode", "off", 0}};
    CHECK_INT(fc_arm_named(ctx, "p", "dropout", mode, 2), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "HOLD");
    CHECK_INT(fc_arm_named(ctx, "p", "offset", NULL, 1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "arguments are NULL");
    CHECK_INT(fc_latest(ctx, "p"), FC_E_NO_FAULT);
    CHECK_ERROR(FC_E_NO_FAULT, "no latest fault");
    finish();
}

/* Model, then its arguments; listed with that name and n. */
static const struct {
    const char *model;
    fc_argument arguments[3];
    const char *listed;
    int64_t n;
} packets[] = {
    {"corruption", {{"byte", NULL, 12}, {"bit", NULL, 3}}, "corruption", 12},
    {"bitflip", {{"byte", NULL, 12}, {"bit", NULL, 3}}, "corruption", 12},
    {"truncate", {{"bytes", NULL, 5}}, "truncate", 5},
    {"extend", {{"count", NULL, 5}, {"byte", NULL, 255}}, "extend", 5},
    {"drop", {{"count", NULL, 3}}, "drop", 3},
    {"drop", {{NULL, NULL, 0}}, "drop", INT64_MAX},
    {"drop", {{"packets", NULL, 3}}, "drop", 3},
    {"repeat", {{"count", NULL, 2}}, "repeat", 2},
    {"lose", {{NULL, NULL, 0}}, "lose", 0},
    {"repeat_last", {{NULL, NULL, 0}}, "repeat_last", 0},
    {"insert", {{"data", "00ffA5", 0}, {"times", NULL, 2}}, "insert", 0},
    {"masquerade", {{"from", "d", 0}}, "masquerade", 0},
    {"resequence", {{"position", NULL, 1}}, "resequence", 1},
    {"block_get", {{NULL, NULL, 0}}, "block_get", 0},
    {"delay_gets", {{"gets", NULL, 4}}, "delay_gets", 4},
    {"delay_time", {{"ns", NULL, 5e8}}, "delay_time", 500000000},
    {"delay", {{"gets", NULL, 4}}, "delay_gets", 4},
    {"delay", {{"ns", NULL, 5e8}}, "delay_time", 500000000},
    {"misroute", {{"to", "d", 0}}, "misroute", 0},
    {"subset", {{"receivers", "x,y", 0}}, "subset", 0},
    {"block_put", {{NULL, NULL, 0}}, "block_put", 0},
};

static fc_fault_id arm_channel(const char *model, const fc_argument *arguments, size_t count) {
    return fc_channel_arm_named(ctx, "c", model, arguments, count);
}

static void every_model_of_a_channel_has_a_name(void) {
    start();
    bool met[40] = {false};
    for (size_t at = 0; at < COUNT(packets); at++) {
        const fc_argument *arguments = packets[at].arguments;
        const fc_fault_id fault = arm_channel(packets[at].model, arguments, given(arguments));
        CHECK(fault > 0);
        look();
        CHECK_INT(last.id, fault);
        CHECK(strcmp(last.model, packets[at].listed) == 0);
        CHECK_INT(last.n, packets[at].n);
        for (int index = 0; fc_model_name(true, index) != NULL; index++)
            if (strcmp(fc_model_name(true, index), packets[at].model) == 0)
                met[index] = true;
    }
    for (int index = 0; fc_model_name(true, index) != NULL; index++) {
        const char *name = fc_model_name(true, index); /* those two are tested below */
        CHECK(met[index] || strcmp(name, "field") == 0 || strcmp(name, "asymmetric") == 0);
    }
    finish();
}

static size_t get(const char *receiver, unsigned char *data) {
    size_t len = 0;
    CHECK_INT(fc_channel_get(ctx, "c", receiver, data, 16, &len), 1);
    return len;
}

static void arguments_reach_the_packet(void) {
    start();
    unsigned char data[16];
    const fc_argument insert[] = {{"data", "00fFa5", 0}};
    CHECK(arm_channel("insert", insert, 1) > 0);
    CHECK_INT(get("", data), 3);
    CHECK(data[0] == 0 && data[1] == 0xff && data[2] == 0xa5);
    fc_channel_remove_faults(ctx, "c");
    const fc_argument extend[] = {{"byte", NULL, 200}, {"count", NULL, 2}};
    CHECK(arm_channel("extend", extend, 2) > 0);
    const fc_argument flip[] = {{"byte", NULL, 0}, {"bit", NULL, 3}};
    CHECK(arm_channel("bitflip", flip, 2) > 0);
    fc_channel_put(ctx, "c", "a", 1);
    CHECK_INT(get("", data), 3);
    CHECK(data[0] == ('a' ^ 8) && data[1] == 200 && data[2] == 200);
    finish();
}

static void a_model_of_a_probe_is_applied_to_a_field(void) {
    start();
    unsigned char data[16];
    const fc_argument field[] = {{"apply", "offset", 0},
                                 {"value", NULL, 258},
                                 {"byte", NULL, 1},
                                 {"type", "u16", 0},
                                 {"big_endian", NULL, 1}};
    CHECK(arm_channel("field", field, 5) > 0);
    fc_channel_put(ctx, "c", "\0\0\0\0", 4);
    CHECK_INT(get("", data), 4);
    CHECK(data[0] == 0 && data[1] == 1 && data[2] == 2 && data[3] == 0);
    CHECK_INT(arm_channel("field", field, 1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "channel \"c\": model offset needs value");
    CHECK_INT(arm_channel("field", field + 1, 4), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "model field needs apply");
    const fc_argument unknown[] = {{"apply", "stuck", 0}, {"bite", NULL, 1}};
    CHECK_INT(arm_channel("field", unknown, 2), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "model stuck has no parameter \"bite\"");
    const fc_argument type[] = {{"apply", "stuck", 0}, {"type", "int", 0}};
    CHECK_INT(arm_channel("field", type, 2), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "type \"int\" is none of");
    const fc_argument drop[] = {{"apply", "drop", 0}};
    CHECK_INT(arm_channel("field", drop, 1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "no model \"drop\" of probes");
    finish();
}

static void listed_receivers_are_told_apart(void) {
    start();
    unsigned char data[16];
    fc_channel_subscribe(ctx, "c", "x");
    fc_channel_subscribe(ctx, "c", "y");
    fc_channel_subscribe(ctx, "c", "z");
    const fc_argument asymmetric[] = {
        {"receivers", "x,z", 0}, {"apply", "bitflip", 0}, {"bit", NULL, 8}};
    CHECK(arm_channel("asymmetric", asymmetric, 3) > 0);
    fc_channel_put(ctx, "c", "aa", 2);
    CHECK_INT(get("x", data), 2);
    CHECK(data[0] == 'a' && data[1] == ('a' ^ 1));
    CHECK_INT(get("y", data), 2);
    CHECK(data[1] == 'a');
    CHECK_INT(get("z", data), 2);
    CHECK(data[1] == ('a' ^ 1));
    const fc_argument subset[] = {{"receivers", "y", 0}};
    CHECK(arm_channel("subset", subset, 1) > 0);
    fc_channel_put(ctx, "c", "bb", 2);
    CHECK_INT(fc_channel_depth(ctx, "c", "x"), 0);
    CHECK_INT(fc_channel_depth(ctx, "c", "y"), 1);
    finish();
}

static void bad_arguments_of_channels_are_refused(void) {
    start();
    const fc_argument both[] = {{"gets", NULL, 1}, {"ns", NULL, 1}};
    CHECK_INT(arm_channel("delay", both, 2), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "either gets or ns");
    CHECK_INT(arm_channel("delay", NULL, 0), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "either gets or ns");
    CHECK_INT(arm_channel("offset", NULL, 0), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "channel \"c\": there is no model \"offset\" of channels");
    const fc_argument odd[] = {{"data", "00f", 0}};
    CHECK_INT(arm_channel("insert", odd, 1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "hexadecimal");
    const fc_argument number[] = {{"data", NULL, 0}};
    CHECK_INT(arm_channel("insert", number, 1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "data must be a text: the packet, in hexadecimal");
    const fc_argument large[] = {{"count", NULL, 1}, {"byte", NULL, 256}};
    CHECK_INT(arm_channel("extend", large, 2), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "byte must be a whole number 0..255");
    const fc_argument bit[] = {{"byte", NULL, 1}, {"bit", NULL, 8}};
    CHECK_INT(arm_channel("bitflip", bit, 2), FC_E_BIT);
    CHECK_ERROR(FC_E_BIT, "0..7");
    const fc_argument negative[] = {{"count", NULL, -1}};
    CHECK_INT(arm_channel("drop", negative, 1), FC_E_ARG);
    CHECK_ERROR(FC_E_ARG, "below 0");
    finish();
}

static void parameters_can_be_asked_for(void) {
    CHECK(strcmp(fc_model_parameter(false, "random_offset", 1)->name, "high") == 0);
    CHECK(strcmp(fc_model_parameter(false, "random_offset", 1)->other, "hi") == 0);
    CHECK(fc_model_parameter(false, "random_offset", 2) == NULL);
    CHECK(fc_model_parameter(false, "random_offset", -1) == NULL);
    CHECK(fc_model_parameter(false, "random_offset", 100) == NULL);
    CHECK(fc_model_parameter(false, "nothing", 0) == NULL);
    CHECK(fc_model_parameter(false, NULL, 0) == NULL);
    CHECK(!fc_model_parameter(true, "drop", 0)->required);
    CHECK_INT(fc_model_parameter(true, "drop", 0)->takes, FC_TAKES_WHOLE);
    CHECK_INT(fc_model_parameter(true, "misroute", 0)->takes, FC_TAKES_TEXT);
    CHECK(strcmp(fc_model_parameter(true, "bitflip", 0)->name, "byte") == 0);
    CHECK(fc_model_name(false, -1) == NULL);
    CHECK(fc_model_name(true, 1000) == NULL);
}

int main(void) {
    every_model_of_a_probe_has_a_name();
    what_does_not_fit_is_refused_by_name();
    every_model_of_a_channel_has_a_name();
    arguments_reach_the_packet();
    a_model_of_a_probe_is_applied_to_a_field();
    listed_receivers_are_told_apart();
    bad_arguments_of_channels_are_refused();
    parameters_can_be_asked_for();
    return CHECK_RESULT();
}
