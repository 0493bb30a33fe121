// The fault models of fc_fault.h.
#include "arming.h"

namespace {

fc_fault_id add(fc_context *ctx, const char *id, fc_model_kind kind, double a, double b = 0,
                int64_t n = 0) {
    return fc::add_model(fc::context_of(ctx), id, {kind, a, b, n});
}

} // namespace

extern "C" {

fc_fault_id fc_add_model(fc_context *ctx, const char *id, const fc_model *model) {
    fc_context &context = fc::context_of(ctx);
    if (model == nullptr)
        return fc::add_probe_fault(context, id, {}, FC_E_ARG, "the model is NULL");
    return fc::add_model(context, id, *model);
}

fc_fault_id fc_add_bitflip(fc_context *ctx, const char *id, int bit) {
    return add(ctx, id, FC_BITFLIP, 0, 0, bit);
}

fc_fault_id fc_add_bitflip_random(fc_context *ctx, const char *id) {
    return add(ctx, id, FC_BITFLIP_RANDOM, 0);
}

fc_fault_id fc_add_stuck(fc_context *ctx, const char *id) {
    return add(ctx, id, FC_STUCK, 0);
}

fc_fault_id fc_add_stuck_bit(fc_context *ctx, const char *id, int bit, bool value) {
    return add(ctx, id, FC_STUCK_BIT, value ? 1 : 0, 0, bit);
}

fc_fault_id fc_add_amplification(fc_context *ctx, const char *id, double factor) {
    return add(ctx, id, FC_AMPLIFICATION, factor);
}

fc_fault_id fc_add_offset(fc_context *ctx, const char *id, double constant) {
    return add(ctx, id, FC_OFFSET, constant);
}

fc_fault_id fc_add_set_to(fc_context *ctx, const char *id, double value) {
    return add(ctx, id, FC_SET_TO, value);
}

fc_fault_id fc_add_noise_uniform(fc_context *ctx, const char *id, double amplitude) {
    return add(ctx, id, FC_NOISE_UNIFORM, amplitude);
}

fc_fault_id fc_add_noise_gauss(fc_context *ctx, const char *id, double deviation) {
    return add(ctx, id, FC_NOISE_GAUSS, deviation);
}

fc_fault_id fc_add_random_offset(fc_context *ctx, const char *id, double low, double high) {
    return add(ctx, id, FC_RANDOM_OFFSET, low, high);
}

fc_fault_id fc_add_drift(fc_context *ctx, const char *id, double per_call, double limit) {
    return add(ctx, id, FC_DRIFT, per_call, limit);
}

fc_fault_id fc_add_drift_timed(fc_context *ctx, const char *id, double per_second, double limit) {
    return add(ctx, id, FC_DRIFT_TIMED, per_second, limit);
}

fc_fault_id fc_add_ramp(fc_context *ctx, const char *id, double target, int64_t calls) {
    return add(ctx, id, FC_RAMP, target, 0, calls);
}

fc_fault_id fc_add_delay(fc_context *ctx, const char *id, int64_t calls) {
    return add(ctx, id, FC_DELAY, 0, 0, calls);
}

fc_fault_id fc_add_quantise(fc_context *ctx, const char *id, double step) {
    return add(ctx, id, FC_QUANTISE, step);
}

fc_fault_id fc_add_dead_zone(fc_context *ctx, const char *id, double centre, double width) {
    return add(ctx, id, FC_DEAD_ZONE, centre, width);
}

fc_fault_id fc_add_saturate(fc_context *ctx, const char *id, double low, double high) {
    return add(ctx, id, FC_SATURATE, low, high);
}

fc_fault_id fc_add_oscillate(fc_context *ctx, const char *id, double amplitude, int64_t calls) {
    return add(ctx, id, FC_OSCILLATE, amplitude, 0, calls);
}

fc_fault_id fc_add_dropout(fc_context *ctx, const char *id, double probability, int mode) {
    return add(ctx, id, FC_DROPOUT, probability, 0, mode);
}

fc_fault_id fc_add_spike(fc_context *ctx, const char *id, double probability, double height) {
    return add(ctx, id, FC_SPIKE, probability, height);
}

fc_fault_id fc_add_held_offset(fc_context *ctx, const char *id, double low, double high,
                               int64_t ns) {
    return add(ctx, id, FC_HELD_OFFSET, low, high, ns);
}

} // extern "C"
