#include "listing.h"

#include "named.h"

#include <algorithm>

namespace fc {

namespace {

fc_listed_fault list_run(const Fault &fault, const FaultRun &run) {
    fc_listed_fault listed = {};
    listed.id = fault.id;
    listed.receiver = "";
    if (!fault.enabled)
        listed.state = FC_DISABLED;
    else if (run.trigger.duration == 0)
        listed.state = FC_EXHAUSTED;
    else
        listed.state = run.trigger.countdown > 0 ? FC_WAITING : FC_ACTIVE;
    listed.calls_left = listed.state == FC_WAITING ? run.trigger.countdown : 0;
    listed.triggered = run.counts.triggered;
    listed.applied = run.counts.applied();
    listed.skipped = run.counts.skipped;
    listed.last_error = run.counts.last_error;
    return listed;
}

bool comes_before(const Listed &a, const Listed &b) {
    return a.id != b.id ? a.id < b.id : a.entry.is_channel < b.entry.is_channel;
}

} // namespace

Listing::Listing(fc_context &context) {
    const std::lock_guard<std::mutex> armed(context.arming);
    for (const auto &probe : context.probes.all()) {
        const std::lock_guard<SpinLock> hold(probe->lock);
        if (probe->listed)
            add(*probe);
    }
    const std::lock_guard<SpinLock> hold(context.traffic);
    for (const auto &channel : context.channels.all())
        if (channel->exists)
            add(*channel);
    std::sort(all_.begin(), all_.end(), comes_before);
    for (Listed &listed : all_) {
        listed.entry.id = listed.id.c_str();
        listed.entry.faults = listed.faults.data();
        listed.entry.fault_count = listed.faults.size();
    }
}

void Listing::add(const Probe &probe) {
    Listed listed{probe.name.text(), {}, {}};
    listed.entry.calls = probe.calls;
    for (int type = 0; type < kTypeCount; ++type)
        if ((probe.state[type].load(std::memory_order_relaxed) & Probe::kUnseen) == 0)
            listed.entry.types |= std::uint32_t{1} << type;
    for (const ProbeFault &fault : probe.faults) {
        listed.faults.push_back(list_run(fault, fault.run));
        listed.faults.back().model = name_of_model(fault.model.kind);
        listed.faults.back().a = fault.model.a;
        listed.faults.back().b = fault.model.b;
        listed.faults.back().n = fault.model.n;
    }
    all_.push_back(std::move(listed));
}

void Listing::add(const Channel &channel) {
    Listed listed{channel.name.text(), {}, {}};
    listed.entry.is_channel = true;
    listed.entry.calls = channel.gets;
    listed.entry.puts = channel.puts;
    for (const ChannelFault &fault : channel.faults) {
        if (fault.model.met_at_put()) {
            add_fault(listed, fault, fault.runs[0], "");
            continue;
        }
        for (std::size_t at = 0; at < channel.receivers.size(); ++at)
            if (!fault.for_one_receiver || fault.receiver == channel.receivers[at].name)
                add_fault(listed, fault, fault.runs[at], channel.receivers[at].name);
    }
    all_.push_back(std::move(listed));
}

void Listing::add_fault(Listed &listed, const ChannelFault &fault, const FaultRun &run,
                        const std::string &receiver) {
    receivers_.push_back(receiver);
    listed.faults.push_back(list_run(fault, run));
    fc_listed_fault &entry = listed.faults.back();
    entry.receiver = receivers_.back().c_str();
    entry.model = name_of_model(fault.model.kind);
    entry.a = fault.model.model.a;
    entry.b = fault.model.model.b;
    entry.n = fault.model.index;
}

} // namespace fc
