// Keeping the state of a context and putting it back: fc_snapshot.h.
//
// What may fail, the copying, comes first; putting back only swaps. A record that is as it was made
// is not kept.
#include "context.h"

#include <array>
#include <cstring>
#include <memory>
#include <utility>

namespace fc {

namespace {

// Of each probe, by its place in the context's table.
struct Seen {
    std::array<std::uint8_t, kTypeCount> states;
    bool listed;
};

template <class Record, class Content> struct Kept {
    Record *record;
    Content content;
};
using KeptProbes = std::vector<Kept<Probe, ProbeContent>>;
using KeptChannels = std::vector<Kept<Channel, ChannelContent>>;

} // namespace

} // namespace fc

struct fc_snapshot {
    std::uint64_t context;
    std::uint64_t seed;
    fc_fault_id next_fault;
    bool counting;
    std::uint64_t error_count;
    std::int64_t manual_ns;
    std::vector<fc::Seen> seen;
    fc::KeptProbes probes; // both in the order of their tables
    fc::KeptChannels channels;
    std::unordered_map<fc_fault_id, fc::FaultPlace> faults;
};

namespace fc {

namespace {

using Hold = std::lock_guard<SpinLock>;

// As plain bytes: nobody writes them meanwhile.
static_assert(sizeof Probe::state == sizeof Seen::states);

Seen seen_of(const Probe &probe) {
    Seen seen{{}, probe.listed};
    std::memcpy(seen.states.data(), &probe.state, sizeof probe.state);
    return seen;
}

// Under the arming lock.
void keep(fc_context &context, fc_snapshot &snapshot) {
    snapshot.context = context.number;
    snapshot.seed = context.seed;
    snapshot.next_fault = context.next_fault;
    snapshot.counting = context.counting;
    snapshot.error_count = context.error_count.load(std::memory_order_relaxed);
    snapshot.manual_ns = context.clock.manual();
    snapshot.faults = context.faults;
    snapshot.seen.reserve(context.probes.all().size());
    for (const auto &probe : context.probes.all()) {
        const Hold hold(probe->lock);
        snapshot.seen.push_back(seen_of(*probe));
        if (!probe->is_new())
            snapshot.probes.push_back({probe.get(), *probe});
    }
    const Hold hold(context.traffic);
    for (const auto &channel : context.channels.all())
        if (!channel->is_new())
            snapshot.channels.push_back({channel.get(), *channel});
}

// The content kept of a record, or null; asked for in the order of the table.
template <class KeptRecords> class InOrder {
  public:
    explicit InOrder(KeptRecords &kept) : next_(kept.begin()), end_(kept.end()) {}
    template <class Record> auto *of(const Record &record) {
        return next_ != end_ && next_->record == &record ? &next_++->content : nullptr;
    }

  private:
    typename KeptRecords::iterator next_;
    typename KeptRecords::iterator end_;
};

// Under the probe's lock.
void put_back(Probe &probe, const Seen &seen, ProbeContent *kept, bool watched) {
    if (kept != nullptr)
        std::swap(static_cast<ProbeContent &>(probe), *kept);
    else if (!probe.is_new())
        static_cast<ProbeContent &>(probe) = ProbeContent();
    probe.listed = seen.listed;
    probe.watched = watched;
    auto states = seen.states;
    for (std::uint8_t &state : states)
        state =
            static_cast<std::uint8_t>((state & ~Probe::kWatched) | (watched ? Probe::kWatched : 0));
    if (std::memcmp(states.data(), &probe.state, sizeof probe.state) == 0)
        return;
    for (std::size_t type = 0; type < states.size(); ++type)
        probe.state[type].store(states[type], std::memory_order_relaxed);
}

void put_back(Channel &channel, ChannelContent *kept, bool watched) {
    if (kept != nullptr)
        std::swap(static_cast<ChannelContent &>(channel), *kept);
    else if (!channel.is_new())
        channel.reset();
    channel.note_faults();
    channel.note_queues();
    channel.watch(watched);
}

void put_back_probes(fc_context &context, const std::vector<Seen> &seen, KeptProbes &kept) {
    InOrder<KeptProbes> in_order(kept);
    Seen unseen{{}, false}; // made since
    unseen.states.fill(Probe::kUnseen);
    std::size_t place = 0;
    for (const auto &probe : context.probes.all()) {
        const Hold hold(probe->lock);
        put_back(*probe, place < seen.size() ? seen[place] : unseen, in_order.of(*probe),
                 context.watched());
        ++place;
    }
}

void put_back_channels(fc_context &context, KeptChannels &kept) {
    InOrder<KeptChannels> in_order(kept);
    const Hold hold(context.traffic);
    for (const auto &channel : context.channels.all())
        put_back(*channel, in_order.of(*channel), context.watched());
}

// Under the arming lock. Fails without a change.
void restore(fc_context &context, const fc_snapshot &snapshot) {
    KeptProbes probes = snapshot.probes;
    KeptChannels channels = snapshot.channels;
    auto faults = snapshot.faults;
    context.faults.swap(faults);
    context.seed = snapshot.seed;
    context.next_fault = snapshot.next_fault;
    context.counting = snapshot.counting;
    context.error_count.store(snapshot.error_count, std::memory_order_relaxed);
    context.clock.set_manual(snapshot.manual_ns);
    put_back_probes(context, snapshot.seen, probes);
    put_back_channels(context, channels);
    context.note_change();
}

int refuse(fc_context &context, const char *why) {
    return report(context, FC_E_ARG, format("fc_restore: %s, context not changed", why));
}

} // namespace

} // namespace fc

extern "C" {

fc_snapshot *fc_save(fc_context *ctx) {
    fc_context &context = fc::context_of(ctx);
    std::unique_ptr<fc_snapshot> snapshot;
    const int code = fc::guarded(context, [&]() -> int {
        auto made = std::make_unique<fc_snapshot>();
        const std::lock_guard<std::mutex> armed(context.arming);
        fc::keep(context, *made);
        snapshot = std::move(made);
        return FC_OK;
    });
    return code == FC_OK ? snapshot.release() : nullptr;
}

int fc_restore(fc_context *ctx, const fc_snapshot *snapshot) {
    fc_context &context = fc::context_of(ctx);
    if (snapshot == nullptr)
        return fc::refuse(context, "the snapshot is NULL");
    if (snapshot->context != context.number)
        return fc::refuse(context, "the snapshot is that of another context");
    return fc::guarded(context, [&]() -> int {
        const std::lock_guard<std::mutex> armed(context.arming);
        fc::restore(context, *snapshot);
        return FC_OK;
    });
}

void fc_release(fc_snapshot *snapshot) {
    delete snapshot;
}

} // extern "C"
