#include "arming.h"

#include "call_inputs.h"

#include <algorithm>
#include <new>

namespace fc {

namespace {

using Arming = std::lock_guard<std::mutex>;
using Hold = std::lock_guard<SpinLock>;

int report_refusal(fc_context &context, const char *kind, const char *id, int code,
                   const char *why) {
    return report(context, code,
                  format("%s %s: %s, fault not added", kind, quoted(id).c_str(), why));
}

// Later trigger calls for the identifier must not hit an older fault.
void remember_refusal(fc_context &context, Space space, const Name &name) {
    const Arming armed(context.arming);
    if (space == Space::probes) {
        if (Probe *probe = context.probes.find(name))
            probe->latest_refused = true;
    } else if (Channel *channel = context.channels.find(name)) {
        channel->latest_refused = true;
    }
}

template <class Record> void start_fault(fc_context &context, Record &record, Fault &fault) {
    fault.id = context.next_fault;
    fault.ordinal = record.next_ordinal;
    fault.random = RandomStream(context.seed, record.name.text(), fault.ordinal);
}

// What can no longer fail once the fault is in its list.
template <class Record> fc_fault_id finish_adding(fc_context &context, Record &record) {
    record.latest_refused = false;
    ++record.next_ordinal;
    context.note_change();
    return context.next_fault++;
}

// Room first, so that the push_back that follows cannot fail.
template <class Faults> void make_room(Faults &faults) {
    if (faults.size() == faults.capacity())
        faults.reserve(2 * faults.size() + 1);
}

// Under the probe's lock, after any change of its faults.
void note_wants(Probe &probe) {
    probe.wants_inputs =
        std::any_of(probe.faults.begin(), probe.faults.end(), [](const ProbeFault &fault) {
            return wants_time(fault.run.trigger, fault.model) || wants_predicate(fault.run.trigger);
        });
    probe.has_memory =
        std::any_of(probe.faults.begin(), probe.faults.end(),
                    [](const ProbeFault &fault) { return keeps_values(fault.model); });
    probe.is_plain = !probe.wants_inputs && !probe.has_memory;
}

fc_fault_id arm_probe(fc_context &context, const Name &name, const Model &model) {
    const Arming armed(context.arming);
    Probe &probe = context.probe(name);
    ProbeFault fault;
    start_fault(context, probe, fault);
    fault.model = model;
    {
        const Hold hold(probe.lock);
        make_room(probe.faults);
        context.faults.emplace(fault.id, FaultPlace{&probe, nullptr});
        probe.faults.push_back(std::move(fault));
        note_wants(probe);
        probe.set_flag(Probe::kArmed);
    }
    probe.listed = true;
    return finish_adding(context, probe);
}

// The channel a fault sends packets to must be there when a packet comes.
void make_target(fc_context &context, const ChannelModel &model) {
    if (model.kind == ChannelModelKind::misroute)
        context.channel(make_name(model.text.data(), model.text.size()));
}

fc_fault_id arm_channel(fc_context &context, const Name &name, const ChannelModel &model) {
    const Arming armed(context.arming);
    Channel &channel = context.channel(name);
    make_target(context, model);
    const Hold hold(context.traffic);
    ChannelFault fault;
    start_fault(context, channel, fault);
    fault.model = model;
    fault.fresh.budget = model.budget;
    fault.runs.assign(channel.receivers.size(), fault.fresh);
    make_room(channel.faults);
    context.faults.emplace(fault.id, FaultPlace{nullptr, &channel});
    channel.faults.push_back(std::move(fault));
    channel.note_faults();
    channel.exists = true;
    return finish_adding(context, channel);
}

template <class Arm>
fc_fault_id add_fault(fc_context &context, Space space, const char *id, int refusal,
                      const char *why, Arm arm) {
    const Name name = read_name(id);
    if (refusal == FC_OK) {
        try {
            return arm(name);
        } catch (const std::bad_alloc &) {
            refusal = FC_E_NOMEM;
            why = "out of memory";
        }
    }
    remember_refusal(context, space, name);
    return report_refusal(context, space == Space::probes ? "probe" : "channel", id, refusal, why);
}

// Under the arming lock. 0 when there is none.
template <class Record> fc_fault_id latest_of(const Record *record) {
    if (record == nullptr || record->latest_refused || record->faults.empty())
        return 0;
    return record->faults.back().id;
}

fc_fault_id find_latest(fc_context &context, Space space, const Name &name) {
    return space == Space::probes ? latest_of(context.probes.find(name))
                                  : latest_of(context.channels.find(name));
}

int report_no_latest(fc_context &context, Space space, const char *id) {
    const char *kind = space == Space::probes ? "probe" : "channel";
    return report(context, FC_E_NO_FAULT,
                  format("%s %s: there is no latest fault to change; it has none, or the one added "
                         "last was refused",
                         kind, quoted(id).c_str()));
}

int report_no_fault(fc_context &context, fc_fault_id id) {
    return report(context, FC_E_NO_FAULT,
                  format("there is no fault %lld in this context", static_cast<long long>(id)));
}

template <class Faults> auto find_in(Faults &faults, fc_fault_id id) {
    return std::find_if(faults.begin(), faults.end(),
                        [id](const Fault &fault) { return fault.id == id; });
}

// Calls change(fault, all its runs...) with the fault's lock held. Under the arming lock.
template <class Change> bool with_fault(fc_context &context, fc_fault_id id, Change change) {
    const auto place = context.faults.find(id);
    if (place == context.faults.end())
        return false;
    if (Probe *probe = place->second.probe) {
        const Hold hold(probe->lock);
        ProbeFault &fault = *find_in(probe->faults, id);
        change(fault, fault.run);
        note_wants(*probe);
    } else {
        const Hold hold(context.traffic);
        ChannelFault &fault = *find_in(place->second.channel->faults, id);
        change(fault, fault.fresh);
        for (FaultRun &run : fault.runs)
            change(fault, run);
        place->second.channel->note_faults();
    }
    return true;
}

bool change_locked(fc_context &context, fc_fault_id id, const TriggerChange &change) {
    return with_fault(context, id, [&change](Fault &, FaultRun &run) {
        change.apply(run.trigger);
        run.state.end_window();
    });
}

template <class Record> void disarm(fc_context &context, Record &record) {
    for (const Fault &fault : record.faults)
        context.faults.erase(fault.id);
    record.faults.clear();
    context.note_change();
}

void disarm_probe(fc_context &context, Probe &probe) {
    const Hold hold(probe.lock);
    disarm(context, probe);
    note_wants(probe);
    probe.clear_flag(Probe::kArmed);
}

void disarm_channel(fc_context &context, Channel &channel) {
    const Hold hold(context.traffic);
    disarm(context, channel);
    channel.note_faults();
}

void remove_locked(fc_context &context, fc_fault_id id, const FaultPlace &place) {
    if (Probe *probe = place.probe) {
        const Hold hold(probe->lock);
        probe->faults.erase(find_in(probe->faults, id));
        note_wants(*probe);
        if (probe->faults.empty())
            probe->clear_flag(Probe::kArmed);
    } else {
        const Hold hold(context.traffic);
        place.channel->faults.erase(find_in(place.channel->faults, id));
        place.channel->note_faults();
    }
    context.faults.erase(id);
    context.note_change();
}

} // namespace

void TriggerChange::apply(Trigger &trigger) const {
    switch (kind) {
    case after:
        trigger.after(calls);
        break;
    case once_after:
        trigger.once_after(calls);
        break;
    case duration:
        trigger.duration = limit < 0 ? Trigger::kForever : limit;
        break;
    case time:
        trigger.conditions |= Trigger::kTime;
        trigger.start = now;
        trigger.delay = delay;
        trigger.length = limit;
        break;
    case random:
        trigger.conditions |= Trigger::kRandom;
        trigger.probability = probability;
        break;
    case periodic:
        trigger.conditions |= Trigger::kPeriodic;
        trigger.period = calls;
        trigger.active = active;
        trigger.passed = 0;
        break;
    case when:
        trigger.conditions |= Trigger::kWhen;
        trigger.predicate = predicate;
        trigger.user = user;
        break;
    case none:
        trigger = Trigger();
        break;
    }
}

fc_fault_id add_probe_fault(fc_context &context, const char *id, const Model &model, int refusal,
                            const char *why) {
    return add_fault(context, Space::probes, id, refusal, why,
                     [&](const Name &name) { return arm_probe(context, name, model); });
}

fc_fault_id add_channel_fault(fc_context &context, const char *channel, const ChannelModel &model,
                              int refusal, const char *why) {
    return add_fault(context, Space::channels, channel, refusal, why,
                     [&](const Name &name) { return arm_channel(context, name, model); });
}

fc_fault_id add_bitflip(fc_context &context, const char *id, std::int64_t bit, std::int64_t most) {
    const Model model{FC_BITFLIP, 0, 0, bit};
    const Text why = format("bit %lld is not one of 0..%lld", static_cast<long long>(bit),
                            static_cast<long long>(most));
    return add_probe_fault(context, id, model, bit >= 0 && bit <= most ? FC_OK : FC_E_BIT,
                           why.c_str());
}

fc_fault_id add_model(fc_context &context, const char *id, const Model &model) {
    const char *why = "";
    const int refusal = check_model(model, &why);
    return add_probe_fault(context, id, model, refusal, why);
}

fc_fault_id latest_fault(fc_context &context, Space space, const char *id) {
    fc_fault_id latest;
    {
        const Arming armed(context.arming);
        latest = find_latest(context, space, read_name(id));
    }
    return latest != 0 ? latest : report_no_latest(context, space, id);
}

int change_trigger(fc_context &context, fc_fault_id fault, const TriggerChange &change) {
    bool found;
    {
        const Arming armed(context.arming);
        found = change_locked(context, fault, change);
    }
    return found ? FC_OK : report_no_fault(context, fault);
}

int change_latest_trigger(fc_context &context, Space space, const char *id,
                          const TriggerChange &change) {
    bool found;
    {
        const Arming armed(context.arming);
        found = change_locked(context, find_latest(context, space, read_name(id)), change);
    }
    return found ? FC_OK : report_no_latest(context, space, id);
}

void remove_probe_faults(fc_context &context, const char *id) {
    const Arming armed(context.arming);
    if (Probe *probe = context.probes.find(read_name(id)))
        disarm_probe(context, *probe);
}

void remove_all_probe_faults(fc_context &context) {
    const Arming armed(context.arming);
    for (const auto &probe : context.probes.all())
        disarm_probe(context, *probe);
}

void remove_channel_faults(fc_context &context, const char *channel) {
    const Arming armed(context.arming);
    if (Channel *known = context.channels.find(read_name(channel)))
        disarm_channel(context, *known);
}

void remove_all_channel_faults(fc_context &context) {
    const Arming armed(context.arming);
    for (const auto &channel : context.channels.all())
        disarm_channel(context, *channel);
}

int restrict_fault(fc_context &context, fc_fault_id id, const char *receiver) {
    bool at_get = false;
    bool found;
    {
        const Arming armed(context.arming);
        const auto place = context.faults.find(id);
        found = place != context.faults.end();
        if (found && place->second.channel != nullptr) {
            std::string name = receiver == nullptr ? "" : receiver;
            const Hold hold(context.traffic);
            ChannelFault &fault = *find_in(place->second.channel->faults, id);
            at_get = !fault.model.met_at_put();
            if (at_get) {
                fault.for_one_receiver = true;
                fault.receiver.swap(name);
            }
        }
    }
    if (!found)
        return report_no_fault(context, id);
    return at_get ? FC_OK
                  : report(context, FC_E_ARG,
                           format("fault %lld is not met at the gets of a channel",
                                  static_cast<long long>(id)));
}

int enable_fault(fc_context &context, fc_fault_id id, bool enabled) {
    bool found;
    {
        const Arming armed(context.arming);
        found = with_fault(context, id,
                           [enabled](Fault &fault, FaultRun &) { fault.enabled = enabled; });
    }
    return found ? FC_OK : report_no_fault(context, id);
}

int seed_fault(fc_context &context, fc_fault_id id, std::uint64_t seed) {
    bool found;
    {
        const Arming armed(context.arming);
        found = with_fault(context, id, [seed](Fault &fault, FaultRun &) {
            fault.random = RandomStream(seed, std::string(), 0);
        });
    }
    return found ? FC_OK : report_no_fault(context, id);
}

int remove_fault(fc_context &context, fc_fault_id id) {
    bool found;
    {
        const Arming armed(context.arming);
        const auto place = context.faults.find(id);
        found = place != context.faults.end();
        if (found)
            remove_locked(context, id, FaultPlace(place->second));
    }
    return found ? FC_OK : report_no_fault(context, id);
}

} // namespace fc
