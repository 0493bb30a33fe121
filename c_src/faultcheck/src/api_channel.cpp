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

int report_no_data(fc_context &context, const char *channel, const char *consequence) {
    return report(context, FC_E_ARG,
                  format("channel %s: data is NULL, %s", quoted(channel).c_str(), consequence));
}

int report_no_receiver(fc_context &context, const Channel &channel) {
    return report_channel(context, FC_E_RECEIVER, channel.name.text().c_str(),
                          "no such receiver is subscribed");
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

int channel_put(fc_context &context, Channel &channel, const char *data, std::size_t len) {
    if (data == nullptr && len > 0)
        return report_no_data(context, channel.name.text().c_str(), "packet not queued");
    return guarded(context, [&]() -> int {
        Reports reports;
        const int result = with_inputs(context, channel, [&](const CallInputs &inputs) {
            const int put = channel.put({context, len > 0 ? data : "", len, inputs, reports});
            record_packet(context, channel, true, inputs, data, len);
            return put;
        });
        if (!reports.empty())
            reports.deliver(context);
        return result;
    });
}

int channel_put(fc_context &context, const char *channel, const char *data, std::size_t len) {
    if (data == nullptr && len > 0)
        return report_no_data(context, channel, "packet not queued");
    return guarded(context, [&]() -> int {
        return channel_put(context, channel_for_put(context, channel), data, len);
    });
}

int channel_get(fc_context &context, Channel &channel, const char *receiver, char *data,
                std::size_t capacity, std::size_t *len) {
    if (data == nullptr && capacity > 0)
        return report_no_data(context, channel.name.text().c_str(), "no packet taken");
    return guarded(context, [&]() -> int {
        Reports reports;
        const int result = with_inputs(context, channel, [&](const CallInputs &inputs) -> int {
            const int index = channel.find_receiver(receiver);
            if (!channel.exists || index < 0)
                return channel.exists ? FC_E_RECEIVER : 0;
            std::size_t size = 0;
            const int taken = channel.get(
                {context, static_cast<std::size_t>(index), inputs, data, capacity, &size, reports});
            if (taken == 1)
                record_packet(context, channel, false, inputs, data, size);
            if (len != nullptr && (taken == 1 || taken == FC_E_SPACE))
                *len = size;
            return taken;
        });
        if (result == FC_E_RECEIVER)
            return report_no_receiver(context, channel);
        if (!reports.empty())
            reports.deliver(context);
        return result;
    });
}

int channel_get(fc_context &context, const char *channel, const char *receiver, char *data,
                std::size_t capacity, std::size_t *len) {
    if (data == nullptr && capacity > 0)
        return report_no_data(context, channel, "no packet taken");
    Channel *known = context.channels.find(read_name(channel));
    return known == nullptr ? 0 : channel_get(context, *known, receiver, data, capacity, len);
}

namespace {

// Result as fc_channel_depth.
std::int64_t depth_of(fc_context &context, const Channel &channel, const char *receiver) {
    {
        const Hold hold(context.traffic);
        if (!channel.exists)
            return 0;
        const int index = channel.find_receiver(receiver);
        if (index >= 0)
            return static_cast<std::int64_t>(
                channel.receivers[static_cast<std::size_t>(index)].queue.depth());
    }
    return report_no_receiver(context, channel);
}

} // namespace

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
    return known == nullptr ? 0 : fc::depth_of(context, *known, receiver);
}

int fc_resolve_channel(fc_context *ctx, const char *channel, fc_channel_handle *handle) {
    fc_context &context = context_of(ctx);
    if (handle == nullptr)
        return fc::report_channel(context, FC_E_ARG, channel,
                                  "the handle is NULL, channel not resolved");
    return fc::guarded(context, [&]() -> int {
        const std::lock_guard<std::mutex> armed(context.arming);
        Channel &known = context.channel(fc::read_name(channel));
        static_assert(sizeof known.state == 1);
        *handle = {reinterpret_cast<const unsigned char *>(&known.state), &known, &context};
        return FC_OK;
    });
}

int fc_channel_put_at(const fc_channel_handle *handle, const void *data, size_t len) {
    return fc::channel_put(*handle->context, *static_cast<Channel *>(handle->channel),
                           static_cast<const char *>(data), len);
}

int fc_channel_get_at(const fc_channel_handle *handle, const char *receiver, void *data,
                      size_t capacity, size_t *len) {
    return fc::channel_get(*handle->context, *static_cast<Channel *>(handle->channel), receiver,
                           static_cast<char *>(data), capacity, len);
}

int64_t fc_channel_depth_at(const fc_channel_handle *handle, const char *receiver) {
    return fc::depth_of(*handle->context, *static_cast<Channel *>(handle->channel), receiver);
}

} // extern "C"
