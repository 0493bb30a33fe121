// The packet channels of fc.h.
#include "api_channel.h"

#include "call_inputs.h"

#include <new>

namespace fc {

namespace {

using Hold = std::lock_guard<SpinLock>;

int report_channel(fc_context &context, int code, const char *channel, const char *what) {
    return report(context, code, format("channel %s: %s", quoted(channel).c_str(), what));
}

Channel &channel_for_put(fc_context &context, const char *id) {
    const Name name = read_name(id);
    if (Channel *known = context.channels.find(name))
        return *known;
    const std::lock_guard<std::mutex> armed(context.arming);
    return context.channel(name);
}

void record_packet(fc_context &context, Channel &channel, bool put, const CallInputs &inputs,
                   const char *data, std::size_t size) {
    const RecordedContent content{data, size};
    if (context.recording.load(std::memory_order_relaxed))
        context.recorder.write(channel.name.text(), &channel.recorded_as,
                               {true, FC_BYTES, put, inputs.now, 0, content, content});
}

// Runs work under the traffic lock with the inputs that the channel's faults ask for.
template <class Work>
int with_inputs(fc_context &context, const Channel &channel, const Work &work) {
    constexpr CallInputs kNone;
    {
        const Hold hold(context.traffic);
        if (!channel.wants_inputs && !context.recording.load(std::memory_order_relaxed))
            return work(kNone);
    }
    InputGatherer gatherer;
    for (;;) {
        {
            const Hold hold(context.traffic);
            if (channel.delays_by_time || channel.masquerades ||
                context.recording.load(std::memory_order_relaxed))
                gatherer.want_time();
            for (const ChannelFault &fault : channel.faults)
                gatherer.want(fault.fresh.trigger, fault.model.model);
            if (gatherer.complete())
                return work(gatherer.inputs());
        }
        gatherer.gather(context.clock);
    }
}

} // namespace

int channel_put(fc_context &context, const char *channel, const char *data, std::size_t len) {
    if (data == nullptr && len > 0)
        return report_channel(context, FC_E_ARG, channel, "data is NULL, packet not queued");
    return guarded(context, [&]() -> int {
        Reports reports;
        Channel &known = channel_for_put(context, channel);
        const int result = with_inputs(context, known, [&](const CallInputs &inputs) {
            record_packet(context, known, true, inputs, data, len);
            return known.put({context, len > 0 ? data : "", len, inputs, reports});
        });
        if (!reports.empty())
            reports.deliver(context);
        return result;
    });
}

int channel_get(fc_context &context, const char *channel, const char *receiver, char *data,
                std::size_t capacity, std::size_t *len) {
    if (data == nullptr && capacity > 0)
        return report_channel(context, FC_E_ARG, channel, "data is NULL, no packet taken");
    Channel *known = context.channels.find(read_name(channel));
    if (known == nullptr)
        return 0;
    return guarded(context, [&]() -> int {
        Reports reports;
        const int result = with_inputs(context, *known, [&](const CallInputs &inputs) -> int {
            const int index = known->find_receiver(receiver);
            if (!known->exists || index < 0)
                return known->exists ? FC_E_RECEIVER : 0;
            std::size_t size = 0;
            const int taken = known->get(
                {context, static_cast<std::size_t>(index), inputs, data, capacity, &size, reports});
            if (taken == 1)
                record_packet(context, *known, false, inputs, data, size);
            if (len != nullptr && (taken == 1 || taken == FC_E_SPACE))
                *len = size;
            return taken;
        });
        if (result == FC_E_RECEIVER)
            return report_channel(context, FC_E_RECEIVER, channel,
                                  "no such receiver is subscribed");
        if (!reports.empty())
            reports.deliver(context);
        return result;
    });
}

} // namespace fc

using fc::Channel;
using fc::context_of;

extern "C" {

int fc_channel_put(fc_context *ctx, const char *channel, const void *data, size_t len) {
    return fc::channel_put(context_of(ctx), channel, static_cast<const char *>(data), len);
}

int fc_channel_get(fc_context *ctx, const char *channel, const char *receiver, void *data,
                   size_t capacity, size_t *len) {
    return fc::channel_get(context_of(ctx), channel, receiver, static_cast<char *>(data), capacity,
                           len);
}

int fc_channel_subscribe(fc_context *ctx, const char *channel, const char *receiver) {
    fc_context &context = context_of(ctx);
    return fc::guarded(context, [&]() -> int {
        const std::lock_guard<std::mutex> armed(context.arming);
        Channel &known = context.channel(fc::read_name(channel));
        const fc::Hold hold(context.traffic);
        known.subscribe(receiver);
        return FC_OK;
    });
}

void fc_channel_clear(fc_context *ctx, const char *channel) {
    fc_context &context = context_of(ctx);
    if (Channel *known = context.channels.find(fc::read_name(channel))) {
        const fc::Hold hold(context.traffic);
        known->clear_queues();
    }
}

int64_t fc_channel_depth(fc_context *ctx, const char *channel, const char *receiver) {
    fc_context &context = context_of(ctx);
    Channel *known = context.channels.find(fc::read_name(channel));
    if (known == nullptr)
        return 0;
    {
        const fc::Hold hold(context.traffic);
        if (!known->exists)
            return 0;
        const int index = known->find_receiver(receiver);
        if (index >= 0)
            return static_cast<int64_t>(
                known->receivers[static_cast<std::size_t>(index)].queue.depth());
    }
    return fc::report_channel(context, FC_E_RECEIVER, channel, "no such receiver is subscribed");
}

} // extern "C"
