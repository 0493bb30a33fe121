// Finding, enabling, seeding and removing faults.
#include "arming.h"

extern "C" {

fc_fault_id fc_latest(fc_context *ctx, const char *id) {
    return fc::latest_fault(fc::context_of(ctx), fc::Space::probes, id);
}

void fc_remove_probe_faults(fc_context *ctx, const char *id) {
    fc::remove_probe_faults(fc::context_of(ctx), id);
}

void fc_remove_all_probe_faults(fc_context *ctx) {
    fc::remove_all_probe_faults(fc::context_of(ctx));
}

int fc_enable(fc_context *ctx, fc_fault_id fault, bool enabled) {
    return fc::enable_fault(fc::context_of(ctx), fault, enabled);
}

int fc_seed_fault(fc_context *ctx, fc_fault_id fault, uint64_t seed) {
    return fc::seed_fault(fc::context_of(ctx), fault, seed);
}

int fc_remove(fc_context *ctx, fc_fault_id fault) {
    return fc::remove_fault(fc::context_of(ctx), fault);
}

fc_fault_id fc_channel_latest(fc_context *ctx, const char *channel) {
    return fc::latest_fault(fc::context_of(ctx), fc::Space::channels, channel);
}

void fc_channel_remove_faults(fc_context *ctx, const char *channel) {
    fc::remove_channel_faults(fc::context_of(ctx), channel);
}

void fc_channel_remove_all_faults(fc_context *ctx) {
    fc::remove_all_channel_faults(fc::context_of(ctx));
}

int fc_num_active(fc_context *ctx, const char *id) {
    fc::Probe *probe = fc::context_of(ctx).probes.find(fc::read_name(id));
    if (probe == nullptr)
        return 0;
    const std::lock_guard<fc::SpinLock> hold(probe->lock);
    int active = 0;
    for (const fc::ProbeFault &fault : probe->faults)
        active += fault.run.active ? 1 : 0;
    return active;
}

} // extern "C"
