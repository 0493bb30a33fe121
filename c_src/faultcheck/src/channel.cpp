#include "channel.h"

#include "channel_get.h"

namespace fc {

namespace {

int get_directly(Channel &channel, std::size_t receiver, char *data, std::size_t capacity,
                 std::size_t *len, Reports &reports) {
    PacketQueue &queue = channel.receivers[receiver].queue;
    if (queue.empty())
        return 0;
    const std::string &packet = queue.entry(0).bytes;
    if (packet.size() > capacity)
        return need_space(channel, packet.size(), capacity, len, reports);
    deliver(packet, data, len);
    queue.remove_front(1);
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
        for (ChannelFault &fault : faults)
            fault.runs.reserve(receivers.size() + 1);
        receivers.push_back(std::move(added));
        for (ChannelFault &fault : faults)
            fault.runs.push_back(fault.fresh);
    }
    exists = has_subscriptions = true;
}

void Channel::put(const char *data, std::size_t size) {
    exists = true;
    if (!has_subscriptions) {
        receivers[0].queue.push_back(data, size);
        return;
    }
    for (Receiver &receiver : receivers)
        if (receiver.subscribed)
            receiver.queue.reserve(1);
    for (Receiver &receiver : receivers)
        if (receiver.subscribed)
            receiver.queue.push_back(data, size);
}

int Channel::get(int receiver, char *data, std::size_t capacity, std::size_t *len,
                 Reports &reports) {
    const auto index = static_cast<std::size_t>(receiver);
    const int result = faults.empty()
                           ? get_directly(*this, index, data, capacity, len, reports)
                           : get_through_faults(*this, index, data, capacity, len, reports);
    if (result >= 0)
        ++gets;
    return result;
}

void Channel::clear_queues() {
    for (Receiver &receiver : receivers)
        receiver.queue.clear();
}

void Channel::reset() {
    exists = has_subscriptions = latest_refused = false;
    faults.clear();
    receivers.resize(1);
    receivers[0].subscribed = false;
    receivers[0].queue.clear();
    gets = 0;
    next_ordinal = 0;
}

} // namespace fc
