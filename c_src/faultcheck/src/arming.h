// Adding, finding, changing and removing faults.
#pragma once

#include "context.h"

#include <cstdint>

namespace fc {

// A fault id, or refusal with the text why; refusal FC_OK adds.
fc_fault_id add_probe_fault(fc_context &context, const char *id, const Model &model, int refusal,
                            const char *why);
fc_fault_id add_channel_fault(fc_context &context, const char *channel, const ChannelModel &model,
                              int refusal, const char *why);

// Parameter checks that several entry points share.
fc_fault_id add_bitflip(fc_context &context, const char *id, std::int64_t bit, std::int64_t most);
fc_fault_id add_model(fc_context &context, const char *id, const Model &model);

enum class Space { probes, channels };

// The fault added last, or FC_E_NO_FAULT (reported).
fc_fault_id latest_fault(fc_context &context, Space space, const char *id);

// Changes of a trigger: what they do to the state for one receiver.
struct TriggerChange {
    enum Kind { after, once_after, duration, time, random, periodic, when, none } kind;
    std::uint64_t calls = 0; // after, once_after; periodic: the period
    std::int64_t limit = 0;  // duration; time: how long
    std::uint64_t active = 0;
    std::int64_t delay = 0;
    std::int64_t now = 0;
    double probability = 0;
    fc_predicate_fn predicate = nullptr;
    void *user = nullptr;

    void apply(Trigger &trigger) const;
};

int change_trigger(fc_context &context, fc_fault_id fault, const TriggerChange &change);
int change_latest_trigger(fc_context &context, Space space, const char *id,
                          const TriggerChange &change);

// FC_OK, FC_E_NO_FAULT; FC_E_ARG for a fault not met at a get.
int restrict_fault(fc_context &context, fc_fault_id id, const char *receiver);
int enable_fault(fc_context &context, fc_fault_id id, bool enabled);
int seed_fault(fc_context &context, fc_fault_id id, std::uint64_t seed);
int remove_fault(fc_context &context, fc_fault_id id);
void remove_probe_faults(fc_context &context, const char *id);
void remove_all_probe_faults(fc_context &context);
void remove_channel_faults(fc_context &context, const char *channel);
void remove_all_channel_faults(fc_context &context);

} // namespace fc
