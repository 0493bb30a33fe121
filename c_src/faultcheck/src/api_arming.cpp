// The faults and triggers of fc.h.
#include "arming.h"

#include <limits>

namespace {

using fc::ChannelModel;
using fc::ChannelModelKind;
using fc::Model;
using fc::ModelKind;
using fc::TriggerChange;

fc_fault_id add_model(fc_context *ctx, const char *id, ModelKind kind, double value) {
    Model model{kind};
    model.value = value;
    return fc::add_probe_fault(fc::context_of(ctx), id, model, FC_OK, "");
}

fc_fault_id add_budget(fc_context *ctx, const char *channel, ChannelModelKind kind,
                       int64_t packets) {
    const bool good = packets >= 0;
    return fc::add_channel_fault(fc::context_of(ctx), channel, ChannelModel{kind},
                                 good ? static_cast<std::uint64_t>(packets) : 0,
                                 good ? FC_OK : FC_E_ARG, "the number of packets is below 0");
}

} // namespace

extern "C" {

fc_fault_id fc_add_bitflip(fc_context *ctx, const char *id, int bit) {
    return fc::add_bitflip(fc::context_of(ctx), id, bit, std::numeric_limits<int>::max());
}

fc_fault_id fc_add_bitflip_random(fc_context *ctx, const char *id) {
    return add_model(ctx, id, ModelKind::bitflip_random, 0);
}

fc_fault_id fc_add_stuck(fc_context *ctx, const char *id) {
    return add_model(ctx, id, ModelKind::stuck, 0);
}

fc_fault_id fc_add_amplification(fc_context *ctx, const char *id, double factor) {
    return add_model(ctx, id, ModelKind::amplification, factor);
}

fc_fault_id fc_add_offset(fc_context *ctx, const char *id, double constant) {
    return add_model(ctx, id, ModelKind::offset, constant);
}

fc_fault_id fc_add_set_to(fc_context *ctx, const char *id, double value) {
    return add_model(ctx, id, ModelKind::set_to, value);
}

fc_fault_id fc_latest(fc_context *ctx, const char *id) {
    return fc::latest_fault(fc::context_of(ctx), fc::Space::probes, id);
}

void fc_remove_probe_faults(fc_context *ctx, const char *id) {
    fc::remove_probe_faults(fc::context_of(ctx), id);
}

void fc_remove_all_probe_faults(fc_context *ctx) {
    fc::remove_all_probe_faults(fc::context_of(ctx));
}

int fc_trigger_after(fc_context *ctx, fc_fault_id fault, uint64_t calls) {
    return fc::change_trigger(fc::context_of(ctx), fault, {TriggerChange::after, calls, 0});
}

int fc_trigger_once_after(fc_context *ctx, fc_fault_id fault, uint64_t calls) {
    return fc::change_trigger(fc::context_of(ctx), fault, {TriggerChange::once_after, calls, 0});
}

int fc_trigger_duration(fc_context *ctx, fc_fault_id fault, int64_t calls) {
    return fc::change_trigger(fc::context_of(ctx), fault, {TriggerChange::duration, 0, calls});
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
