// The record of one packet channel.
#pragma once

#include "fault.h"
#include "name.h"
#include "packet_queue.h"
#include "report.h"

namespace fc {

enum class ChannelModelKind : std::uint8_t {
    corruption,
    drop,
    repeat,
};

struct ChannelModel {
    ChannelModelKind kind;
    std::int64_t index = 0; // corruption: byte
    std::int64_t bit = 0;   // corruption
};

struct ChannelFault : Fault {
    ChannelModel model;
    FaultRun fresh;             // as armed, for receivers still to come
    std::vector<FaultRun> runs; // one for each receiver
};

struct Receiver {
    std::string name;
    bool subscribed = false;
    PacketQueue queue;
};

// Everything but the name is under the context's traffic lock.
struct Channel {
    explicit Channel(const Name &identifier) : name(identifier), receivers(1) {}

    StoredName name;
    bool exists = false; // got a packet, a fault or a receiver since fc_new or fc_reset
    bool has_subscriptions = false;
    std::vector<Receiver> receivers; // the first is ""
    std::vector<ChannelFault> faults;
    std::uint64_t gets = 0;
    bool latest_refused = false;
    std::uint64_t next_ordinal = 0;

    // The receiver of that name that may get packets, or -1.
    int find_receiver(const char *receiver) const;
    void subscribe(const char *receiver);
    void put(const char *data, std::size_t size);
    // Result and parameters of fc_channel_get.
    int get(int receiver, char *data, std::size_t capacity, std::size_t *len, Reports &reports);
    void clear_queues();
    void reset();
};

} // namespace fc
