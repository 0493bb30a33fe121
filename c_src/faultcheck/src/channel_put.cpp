#include "channel_put.h"

#include "checkpoint.h"
#include "context.h"
#include "field.h"

#include <algorithm>
#include <optional>

namespace fc {

namespace {

bool lists(const std::vector<std::string> &names, const std::string &name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

// What the faults have made of a put.
class PutPlan {
  public:
    PutPlan(Channel &channel, const PutCall &call)
        : channel_(channel), call_(call), copies_(channel.receivers.size()) {}

    bool blocked = false;

    // FC_OK or why the fault was skipped.
    int apply(ChannelFault &fault, FaultRun &run) {
        const ChannelModel &model = fault.model;
        switch (model.kind) {
        case ChannelModelKind::delay_gets:
            delay_gets_ += static_cast<std::uint64_t>(model.index);
            return FC_OK;
        case ChannelModelKind::delay_time:
            until_ns_ = std::max(until_ns_, later(call_.inputs.now, model.index));
            return FC_OK;
        case ChannelModelKind::misroute:
            target_ = call_.context.channels.find(make_name(model.text.data(), model.text.size()));
            return FC_OK;
        case ChannelModelKind::asymmetric:
            return alter(fault, run);
        case ChannelModelKind::subset:
            for (Copy &copy : copies_)
                copy.excluded = copy.excluded || !lists(model.receivers, name_of(copy));
            return FC_OK;
        case ChannelModelKind::block_put:
            blocked = true;
            return FC_OK;
        default:
            return FC_OK; // met at a get
        }
    }

    void carry_out() {
        if (target_ != nullptr && target_ != &channel_) {
            put_directly(*target_, call_, delay_gets_, until_ns_);
            target_->exists = true;
            target_->note_queues();
            if (until_ns_ != Hiding().until_ns)
                target_->delays_by_time = target_->wants_inputs = true;
            return;
        }
        for (const Copy &copy : copies_)
            if (goes_to(copy))
                receiver_of(copy).queue.prepare_back(bytes_of(copy).size());
        for (const Copy &copy : copies_)
            if (goes_to(copy))
                receiver_of(copy).queue.push_back(bytes_of(copy).data(), bytes_of(copy).size(),
                                                  hiding(receiver_of(copy).gets));
    }

  private:
    struct Copy {
        bool excluded = false;
        std::optional<std::string> altered;
    };
    struct Bytes {
        const char *start;
        std::size_t length;
        const char *data() const {
            return start;
        }
        std::size_t size() const {
            return length;
        }
    };

    static std::int64_t later(std::int64_t now, std::int64_t ns) {
        constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
        return now > most - ns ? most : now + ns;
    }

    std::size_t index_of(const Copy &copy) const {
        return static_cast<std::size_t>(&copy - copies_.data());
    }
    Receiver &receiver_of(const Copy &copy) const {
        return channel_.receivers[index_of(copy)];
    }
    const std::string &name_of(const Copy &copy) const {
        return receiver_of(copy).name;
    }
    bool goes_to(const Copy &copy) const {
        return !copy.excluded && channel_.gets_packets(receiver_of(copy));
    }
    Bytes bytes_of(const Copy &copy) const {
        if (copy.altered)
            return {copy.altered->data(), copy.altered->size()};
        return {call_.data, call_.size};
    }
    Hiding hiding(std::uint64_t gets) const {
        return {gets + delay_gets_, until_ns_};
    }

    // All listed receivers get the same altered copy.
    int alter(ChannelFault &fault, FaultRun &run) {
        std::optional<std::string> altered;
        for (Copy &copy : copies_) {
            if (!lists(fault.model.receivers, name_of(copy)))
                continue;
            if (!altered) {
                altered = std::string(bytes_of(copy).data(), bytes_of(copy).size());
                const int code =
                    apply_to_field({fault.model.model, run.state, fault.random, call_.inputs},
                                   fault.model.field, &*altered);
                if (code != FC_OK)
                    return code;
            }
            copy.altered = altered;
        }
        return FC_OK;
    }

    Channel &channel_;
    const PutCall &call_;
    std::vector<Copy> copies_; // by receiver
    Channel *target_ = nullptr;
    std::uint64_t delay_gets_ = 0;
    std::int64_t until_ns_ = Hiding().until_ns;
};

Text why_blocked(const Channel &channel, const ChannelFault &fault) {
    return format("channel %s, fault %lld: packet refused, puts are blocked",
                  quoted(channel.name.text().c_str()).c_str(), static_cast<long long>(fault.id));
}

void walk_faults(Channel &channel, const PutCall &call, PutPlan &plan, Reports &reports) {
    for (ChannelFault &fault : channel.faults) {
        FaultRun &run = fault.runs[0];
        if (!fault.model.met_at_put() || !run.advance(fault.enabled, call.inputs, fault.random))
            continue;
        const int code = plan.apply(fault, run);
        if (code != FC_OK) {
            run.count_skipped(code);
            reports.add(code, fault.id, fault.meets(code),
                        why_skipped(channel, fault, code, call.size));
        } else if (fault.model.kind == ChannelModelKind::block_put) {
            reports.add(FC_E_BLOCKED, fault.id, fault.meets(FC_E_BLOCKED),
                        why_blocked(channel, fault));
        }
    }
}

} // namespace

Text why_skipped(const Channel &channel, const ChannelFault &fault, int code, std::size_t size) {
    const Text name = quoted(channel.name.text().c_str());
    const auto id = static_cast<long long>(fault.id);
    if (code != FC_E_INDEX)
        return format("channel %s, fault %lld: the model does not apply to the field or its value, "
                      "fault skipped",
                      name.c_str(), id);
    if (fault.model.kind == ChannelModelKind::corruption)
        return format("channel %s, fault %lld: corruption of byte %lld skipped, the packet has %zu "
                      "bytes",
                      name.c_str(), id, static_cast<long long>(fault.model.index), size);
    return format("channel %s, fault %lld: field at byte %zu skipped, the packet has %zu bytes",
                  name.c_str(), id, fault.model.field.offset, size);
}

int put_directly(Channel &channel, const PutCall &call, std::uint64_t gets, std::int64_t until_ns) {
    if (!channel.has_subscriptions) {
        Receiver &only = channel.receivers[0];
        only.queue.prepare_back(call.size);
        only.queue.push_back(call.data, call.size, {only.gets + gets, until_ns});
        return FC_OK;
    }
    for (Receiver &receiver : channel.receivers)
        if (channel.gets_packets(receiver))
            receiver.queue.prepare_back(call.size);
    for (Receiver &receiver : channel.receivers)
        if (channel.gets_packets(receiver))
            receiver.queue.push_back(call.data, call.size, {receiver.gets + gets, until_ns});
    return FC_OK;
}

int put_through_faults(Channel &channel, const PutCall &call) {
    Checkpoint before(channel, 0);
    try {
        PutPlan plan(channel, call);
        Reports met;
        walk_faults(channel, call, plan, met);
        if (!plan.blocked)
            plan.carry_out();
        call.reports = std::move(met);
        return plan.blocked ? FC_E_BLOCKED : FC_OK;
    } catch (...) {
        before.restore();
        throw;
    }
}

} // namespace fc
