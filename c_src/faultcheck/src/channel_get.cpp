#include "channel_get.h"

#include "channel_put.h"
#include "checkpoint.h"
#include "context.h"
#include "get_fault.h"

namespace fc {

namespace {

void walk_faults(Channel &channel, const GetCall &call, Transit &transit, Reports &reports) {
    Receiver &receiver = channel.receivers[call.receiver];
    for (ChannelFault &fault : channel.faults) {
        FaultRun &run = fault.runs[call.receiver];
        if (fault.model.met_at_put() || (fault.for_one_receiver && fault.receiver != receiver.name))
            continue;
        if (!run.advance(fault.enabled, call.inputs, fault.random))
            continue;
        if (transit.blocked || (!transit.present && !works_without_packet(fault.model.kind))) {
            ++run.counts.idle;
            continue;
        }
        const std::size_t size = transit.current.size();
        const int code = apply_at_get({fault, run, call, receiver}, transit);
        if (code == FC_OK)
            continue;
        run.count_skipped(code);
        reports.add(code, fault.id, fault.meets(code), why_skipped(channel, fault, code, size));
    }
}

// The channels that faults may have taken a packet of.
void note_sources(const Channel &channel, fc_context &context) {
    for (const ChannelFault &fault : channel.faults)
        if (fault.model.kind == ChannelModelKind::masquerade)
            if (Channel *source = masquerade_source(context, fault.model))
                source->note_queues();
}

} // namespace

int need_space(const Channel &channel, std::size_t needed, const GetCall &call) {
    if (call.len != nullptr)
        *call.len = needed;
    call.reports.add(FC_E_SPACE, 0, true,
                     format("channel %s: a packet of %zu bytes does not fit a buffer of %zu",
                            quoted(channel.name.text().c_str()).c_str(), needed, call.capacity));
    return FC_E_SPACE;
}

int get_through_faults(Channel &channel, const GetCall &call) {
    Checkpoint before(channel, call.receiver);
    try {
        Reports met;
        Receiver &receiver = channel.receivers[call.receiver];
        Transit transit(receiver, call.inputs);
        walk_faults(channel, call, transit, met);
        if (transit.present && transit.current.size() > call.capacity) {
            before.restore();
            return need_space(channel, transit.current.size(), call);
        }
        transit.reserve_for_commit();
        transit.commit();
        if (channel.masquerades)
            note_sources(channel, call.context);
        call.reports = std::move(met);
        if (!transit.present)
            return 0;
        deliver(transit.current, call);
        receiver.last.swap(transit.current);
        receiver.has_last = true;
        return 1;
    } catch (...) {
        before.restore();
        throw;
    }
}

} // namespace fc
