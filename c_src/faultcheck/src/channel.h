// The record of one packet channel.
#pragma once

#include "channel_model.h"
#include "fault.h"
#include "name.h"
#include "packet_queue.h"
#include "recorder.h"
#include "report.h"

#include <atomic>
#include <cstdint>

namespace fc {

struct ChannelFault : Fault {
    ChannelModel model;
    bool for_one_receiver = false;
    std::string receiver;       // if so
    FaultRun fresh;             // as armed, for receivers still to come
    std::vector<FaultRun> runs; // one for each receiver; a fault met at a put uses the first
};

struct Receiver {
    std::string name;
    bool subscribed = false;
    std::uint64_t gets = 0;
    PacketQueue queue;
    bool has_last = false;
    std::string last; // the packet delivered last
};

// What a get works with.
struct GetCall {
    fc_context &context;
    std::size_t receiver;
    const CallInputs &inputs;
    char *data;
    std::size_t capacity;
    std::size_t *len;
    Reports &reports;
};

// What a put works with.
struct PutCall {
    fc_context &context;
    const char *data;
    std::size_t size;
    const CallInputs &inputs;
    Reports &reports;
};

// What packets and faults have made of a channel: a snapshot copies it.
struct ChannelContent {
    bool exists = false; // got a packet, a fault or a receiver since fc_new or fc_reset
    bool has_subscriptions = false;
    bool wants_inputs = false;   // a fault or a delayed packet asks for the time or a predicate
    bool delays_by_time = false; // there has been a fault that does, since fc_new or fc_reset
    bool has_put_faults = false;
    bool masquerades = false; // a fault takes packets of another channel, which may be delayed
    std::vector<Receiver> receivers; // the first is ""
    std::vector<ChannelFault> faults;
    std::uint64_t puts = 0;
    std::uint64_t gets = 0;
    bool latest_refused = false;
    std::uint64_t next_ordinal = 0;

    // As it was made.
    bool is_new() const {
        return !exists && next_ordinal == 0 && !latest_refused;
    }
};

// Everything but the name is written under the context's traffic lock, and read under it save the
// state.
struct Channel : ChannelContent {
    explicit Channel(const Name &identifier) : name(identifier) {
        receivers.resize(1);
    }

    StoredName name;

    // Why a packet cannot be handed over past the channel; 0 for an idle one.
    enum State : std::uint8_t {
        kArmed = 1,
        kQueued = 2,
        kWatched = 4, // packets are recorded or counted
    };
    std::atomic<std::uint8_t> state{0};

    RecordedAs recorded_as;

    // The receiver of that name, or -1.
    int find_receiver(const char *receiver) const;
    bool gets_packets(const Receiver &receiver) const {
        return has_subscriptions ? receiver.subscribed : &receiver == &receivers.front();
    }
    void subscribe(const char *receiver);
    // FC_OK or FC_E_BLOCKED. Fails without a change.
    int put(const PutCall &call);
    // Result as fc_channel_get.
    int get(const GetCall &call);
    // After any change of the faults.
    void note_faults();
    // After any change of the queues.
    void note_queues();
    void watch(bool on) {
        set_state(kWatched, on);
    }
    void clear_queues();
    void reset();

  private:
    void set_state(State flag, bool on) {
        const std::uint8_t before = state.load(std::memory_order_relaxed);
        const int after = on ? before | flag : before & ~flag;
        if (after != before)
            state.store(static_cast<std::uint8_t>(after), std::memory_order_relaxed);
    }
};

} // namespace fc
