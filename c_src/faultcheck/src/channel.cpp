#include "channel.h"

#include "call_inputs.h"
#include "channel_get.h"
#include "channel_put.h"

namespace fc {

namespace {

int get_directly(Channel &channel, const GetCall &call) {
    Receiver &receiver = channel.receivers[call.receiver];
    PacketQueue &queue = receiver.queue;
    if (queue.entries() == 0 || !queue.entry(0).hiding.over(receiver.gets, call.inputs.now))
        return 0;
    const std::size_t size = queue.entry(0).bytes.size();
    if (size > call.capacity)
        return need_space(channel, size, call);
    queue.take_front(&receiver.last);
    receiver.has_last = true;
    deliver(receiver.last, call);
    return 1;
}

} // namespace

int Channel::find_receiver(const char *receiver) const {
    if (receiver == nullptr || *receiver == '\0')
        return 0;
    for (std::size_t at = 1; at < receivers.size(); ++at)
        if (receivers[at].name == receiver)
            return static_cast<int>(at);
    return -1;
}

void Channel::subscribe(const char *receiver) {
    const int known = find_receiver(receiver);
    if (known >= 0) {
        receivers[static_cast<std::size_t>(known)].subscribed = true;
    } else {
        Receiver added;
        added.name = receiver;
        added.subscribed = true;
        std::vector<FaultRun> fresh;
        for (ChannelFault &fault : faults) {
            fault.runs.reserve(receivers.size() + 1);
            fresh.push_back(fault.fresh);
        }
        receivers.push_back(std::move(added));
        for (std::size_t at = 0; at < faults.size(); ++at)
            faults[at].runs.push_back(std::move(fresh[at]));
    }
    exists = has_subscriptions = true;
}

int Channel::put(const PutCall &call) {
    const int result = has_put_faults ? put_through_faults(*this, call)
                                      : put_directly(*this, call, 0, Hiding().until_ns);
    exists = true;
    ++puts;
    note_queues();
    return result;
}

int Channel::get(const GetCall &call) {
    const int result = faults.empty() ? get_directly(*this, call) : get_through_faults(*this, call);
    if (result >= 0) {
        ++gets;
        ++receivers[call.receiver].gets;
        note_queues();
    }
    return result;
}

void Channel::note_faults() {
    wants_inputs = delays_by_time;
    has_put_faults = masquerades = false;
    for (const ChannelFault &fault : faults) {
        if (fault.model.kind == ChannelModelKind::delay_time)
            delays_by_time = wants_inputs = true;
        if (fault.model.kind == ChannelModelKind::masquerade)
            masquerades = wants_inputs = true;
        if (wants_time(fault.fresh.trigger, fault.model.model) ||
            wants_predicate(fault.fresh.trigger))
            wants_inputs = true;
        has_put_faults = has_put_faults || fault.model.met_at_put();
    }
    set_state(kArmed, !faults.empty());
}

void Channel::note_queues() {
    bool queued = false;
    for (const Receiver &receiver : receivers)
        queued = queued || receiver.queue.entries() > 0;
    set_state(kQueued, queued);
}

void Channel::clear_queues() {
    for (Receiver &receiver : receivers)
        receiver.queue.clear();
    note_queues();
}

void Channel::reset() {
    exists = has_subscriptions = latest_refused = delays_by_time = false;
    faults.clear();
    note_faults();
    receivers.resize(1);
    receivers[0].subscribed = receivers[0].has_last = false;
    receivers[0].gets = 0;
    receivers[0].queue.clear();
    note_queues();
    watch(false);
    puts = gets = 0;
    next_ordinal = 0;
}

} // namespace fc
