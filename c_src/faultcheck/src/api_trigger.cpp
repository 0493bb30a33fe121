// The triggers of fc_trigger.h.
#include "arming.h"

namespace {

using fc::TriggerChange;

int change(fc_context *ctx, fc_fault_id fault, const TriggerChange &trigger) {
    return fc::change_trigger(fc::context_of(ctx), fault, trigger);
}

int refuse(fc_context *ctx, fc_fault_id fault, const char *why) {
    return fc::report(
        fc::context_of(ctx), FC_E_ARG,
        fc::format("fault %lld: %s, trigger not changed", static_cast<long long>(fault), why));
}

} // namespace

extern "C" {

int fc_trigger_after(fc_context *ctx, fc_fault_id fault, uint64_t calls) {
    TriggerChange trigger{TriggerChange::after};
    trigger.calls = calls;
    return change(ctx, fault, trigger);
}

int fc_trigger_once_after(fc_context *ctx, fc_fault_id fault, uint64_t calls) {
    TriggerChange trigger{TriggerChange::once_after};
    trigger.calls = calls;
    return change(ctx, fault, trigger);
}

int fc_trigger_duration(fc_context *ctx, fc_fault_id fault, int64_t calls) {
    TriggerChange trigger{TriggerChange::duration};
    trigger.limit = calls;
    return change(ctx, fault, trigger);
}

int fc_trigger_time(fc_context *ctx, fc_fault_id fault, int64_t delay_ns, int64_t duration_ns) {
    if (delay_ns < 0)
        return refuse(ctx, fault, "the delay is below 0");
    TriggerChange trigger{TriggerChange::time};
    trigger.delay = delay_ns;
    trigger.limit = duration_ns;
    trigger.now = fc_now(ctx);
    return change(ctx, fault, trigger);
}

int fc_trigger_random(fc_context *ctx, fc_fault_id fault, double probability) {
    if (!(probability >= 0 && probability <= 1))
        return refuse(ctx, fault, "the probability is not 0..1");
    TriggerChange trigger{TriggerChange::random};
    trigger.probability = probability;
    return change(ctx, fault, trigger);
}

int fc_trigger_periodic(fc_context *ctx, fc_fault_id fault, uint64_t period, uint64_t active) {
    if (period == 0)
        return refuse(ctx, fault, "the period is 0");
    TriggerChange trigger{TriggerChange::periodic};
    trigger.calls = period;
    trigger.active = active;
    return change(ctx, fault, trigger);
}

int fc_trigger_when(fc_context *ctx, fc_fault_id fault, fc_predicate_fn predicate, void *user) {
    if (predicate == nullptr)
        return refuse(ctx, fault, "the predicate is NULL");
    TriggerChange trigger{TriggerChange::when};
    trigger.predicate = predicate;
    trigger.user = user;
    return change(ctx, fault, trigger);
}

int fc_trigger_none(fc_context *ctx, fc_fault_id fault) {
    return change(ctx, fault, TriggerChange{TriggerChange::none});
}

} // extern "C"
