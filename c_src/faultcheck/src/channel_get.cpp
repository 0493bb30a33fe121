#include "channel_get.h"

#include <new>

namespace fc {

namespace {

// The packet on its way to the receiver while the faults are walked.
struct Transit {
    QueueView queue;
    bool present = false; // there is a packet to deliver
    std::string current;
    std::string clean; // current before any corruption

    explicit Transit(PacketQueue &waiting) : queue(waiting) {
        take_next();
    }

    void take_next() {
        present = queue.take(&clean);
        current = clean;
    }
};

int corrupt(const ChannelModel &model, Transit &transit) {
    if (static_cast<std::uint64_t>(model.index) >= transit.current.size())
        return FC_E_INDEX;
    char &byte = transit.current[static_cast<std::size_t>(model.index)];
    byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1u << model.bit));
    return FC_OK;
}

int drop(FaultRun &run, Transit &transit) {
    if (run.budget == 0)
        return FC_OK;
    const std::uint64_t queued = transit.queue.depth();
    const std::uint64_t discarded = run.budget <= queued ? run.budget : queued + 1;
    run.budget -= discarded;
    transit.queue.discard(discarded - 1);
    transit.take_next();
    return FC_OK;
}

// The copies are of the clean packet, so later gets apply the faults to them afresh.
int repeat(FaultRun &run, Transit &transit) {
    if (run.budget == 0)
        return FC_OK;
    transit.queue.put_back(transit.clean, run.budget);
    run.budget = 0;
    return FC_OK;
}

int apply(const ChannelModel &model, FaultRun &run, Transit &transit) {
    switch (model.kind) {
    case ChannelModelKind::corruption:
        return corrupt(model, transit);
    case ChannelModelKind::drop:
        return drop(run, transit);
    case ChannelModelKind::repeat:
        return repeat(run, transit);
    }
    return FC_E_ARG;
}

Text why_skipped(const Channel &channel, const ChannelFault &fault, std::size_t size) {
    return format(
        "channel %s, fault %lld: corruption of byte %lld skipped, the packet has %zu bytes",
        quoted(channel.name.text().c_str()).c_str(), static_cast<long long>(fault.id),
        static_cast<long long>(fault.model.index), size);
}

void walk_faults(Channel &channel, std::size_t receiver, const CallInputs &inputs, Transit &transit,
                 Reports &reports) {
    for (ChannelFault &fault : channel.faults) {
        FaultRun &run = fault.runs[receiver];
        if (!run.advance(fault.enabled, inputs, fault.random))
            continue;
        if (!transit.present) {
            ++run.counts.idle;
            continue;
        }
        const int code = apply(fault.model, run, transit);
        if (code == FC_OK)
            continue;
        run.count_skipped(code);
        reports.add(code, fault.id, fault.meets(code),
                    why_skipped(channel, fault, transit.current.size()));
    }
}

// The faults' state before a get, to be put back when the get fails.
class Checkpoint {
  public:
    Checkpoint(Channel &channel, std::size_t receiver) : channel_(channel), receiver_(receiver) {
        before_.reserve(channel.faults.size());
        for (const ChannelFault &fault : channel.faults)
            before_.push_back({fault, fault.runs[receiver]});
    }
    void restore() {
        for (std::size_t at = 0; at < before_.size(); ++at) {
            static_cast<Fault &>(channel_.faults[at]) = before_[at].fault;
            std::swap(channel_.faults[at].runs[receiver_], before_[at].run);
        }
    }

  private:
    struct Before {
        Fault fault;
        FaultRun run;
    };
    Channel &channel_;
    std::size_t receiver_;
    std::vector<Before> before_;
};

} // namespace

int need_space(const Channel &channel, std::size_t needed, std::size_t capacity, std::size_t *len,
               Reports &reports) {
    if (len != nullptr)
        *len = needed;
    reports.add(FC_E_SPACE, 0, true,
                format("channel %s: a packet of %zu bytes does not fit a buffer of %zu",
                       quoted(channel.name.text().c_str()).c_str(), needed, capacity));
    return FC_E_SPACE;
}

int get_through_faults(Channel &channel, std::size_t receiver, char *data, std::size_t capacity,
                       std::size_t *len, Reports &reports) {
    Checkpoint before(channel, receiver);
    try {
        Reports met;
        Transit transit(channel.receivers[receiver].queue);
        walk_faults(channel, receiver, CallInputs(), transit, met);
        if (transit.present && transit.current.size() > capacity) {
            before.restore();
            return need_space(channel, transit.current.size(), capacity, len, reports);
        }
        transit.queue.reserve_for_commit();
        if (transit.present)
            deliver(transit.current, data, len);
        transit.queue.commit();
        reports = std::move(met);
        return transit.present ? 1 : 0;
    } catch (const std::bad_alloc &) {
        before.restore();
        throw;
    }
}

} // namespace fc
