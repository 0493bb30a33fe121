// Faults on channels, and finding and removing faults.
#include "arming.h"

namespace {

using fc::ChannelModel;
using fc::ChannelModelKind;

fc_fault_id add_budget(fc_context *ctx, const char *channel, ChannelModelKind kind,
                       int64_t packets) {
    const bool good = packets >= 0;
    return fc::add_channel_fault(fc::context_of(ctx), channel, ChannelModel{kind},
                                 good ? static_cast<std::uint64_t>(packets) : 0,
                                 good ? FC_OK : FC_E_ARG, "the number of packets is below 0");
}

} // namespace

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

int fc_remove(fc_context *ctx, fc_fault_id fault) {
    return fc::remove_fault(fc::context_of(ctx), fault);
}

fc_fault_id fc_channel_add_corruption(fc_context *ctx, const char *channel, int byte, int bit) {
    ChannelModel model{ChannelModelKind::corruption};
    model.index = byte;
    model.bit = bit;
    int refusal = FC_OK;
    const char *why = "";
    if (byte < 0) {
        refusal = FC_E_INDEX;
        why = "the byte index is below 0";
    } else if (bit < 0 || bit > 7) {
        refusal = FC_E_BIT;
        why = "the bit is not one of 0..7";
    }
    return fc::add_channel_fault(fc::context_of(ctx), channel, model, 0, refusal, why);
}

fc_fault_id fc_channel_add_drop(fc_context *ctx, const char *channel, int64_t packets) {
    return add_budget(ctx, channel, ChannelModelKind::drop, packets);
}

fc_fault_id fc_channel_add_repeat(fc_context *ctx, const char *channel, int64_t packets) {
    return add_budget(ctx, channel, ChannelModelKind::repeat, packets);
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
