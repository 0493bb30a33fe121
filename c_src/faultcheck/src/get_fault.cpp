#include "get_fault.h"

#include "context.h"
#include "field.h"

namespace fc {

namespace {

int corrupt(const ChannelModel &model, Transit &transit) {
    if (static_cast<std::uint64_t>(model.index) >= transit.current.size())
        return FC_E_INDEX;
    char &byte = transit.current[static_cast<std::size_t>(model.index)];
    byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1u << model.bit));
    return FC_OK;
}

int truncate(const ChannelModel &model, Transit &transit) {
    if (static_cast<std::uint64_t>(model.index) < transit.current.size())
        transit.current.resize(static_cast<std::size_t>(model.index));
    return FC_OK;
}

int extend(const ChannelModel &model, Transit &transit) {
    transit.current.append(static_cast<std::size_t>(model.index), static_cast<char>(model.bit));
    return FC_OK;
}

int drop(std::uint64_t *budget, Transit &transit) {
    if (*budget == 0)
        return FC_OK;
    --*budget;
    *budget -= transit.queue().discard(*budget);
    transit.take_next();
    return FC_OK;
}

// The copies are of the clean packet, so later gets apply the faults to them afresh.
int repeat(std::uint64_t *budget, Transit &transit) {
    if (*budget > 0)
        transit.queue().put_back(transit.clean, *budget);
    *budget = 0;
    return FC_OK;
}

int insert(const ChannelModel &model, std::uint64_t *budget, Transit &transit) {
    if (*budget == 0)
        return FC_OK;
    --*budget;
    transit.choose(model.text);
    return FC_OK;
}

int masquerade(const GetFault &fault, Transit &transit) {
    Channel *other = masquerade_source(fault.call.context, fault.fault.model);
    if (other == nullptr || !other->exists)
        return FC_OK;
    const int same = other->find_receiver(fault.receiver.name.c_str());
    Receiver &source = other->receivers[same < 0 ? 0 : static_cast<std::size_t>(same)];
    transit.choose_from(source.queue, source.gets);
    return FC_OK;
}

int repeat_last(const Receiver &receiver, Transit &transit) {
    if (receiver.has_last)
        transit.choose(receiver.last);
    return FC_OK;
}

} // namespace

bool works_without_packet(ChannelModelKind kind) {
    return kind == ChannelModelKind::insert || kind == ChannelModelKind::masquerade ||
           kind == ChannelModelKind::repeat_last;
}

Channel *masquerade_source(fc_context &context, const ChannelModel &model) {
    return context.channels.find(make_name(model.text.data(), model.text.size()));
}

int apply_at_get(const GetFault &fault, Transit &transit) {
    const ChannelModel &model = fault.fault.model;
    std::uint64_t one = 1;
    switch (model.kind) {
    case ChannelModelKind::corruption:
        return corrupt(model, transit);
    case ChannelModelKind::field:
        return apply_to_field({model.model, fault.run.state, fault.fault.random, fault.call.inputs},
                              model.field, &transit.current);
    case ChannelModelKind::truncate:
        return truncate(model, transit);
    case ChannelModelKind::extend:
        return extend(model, transit);
    case ChannelModelKind::drop:
        return drop(&fault.run.budget, transit);
    case ChannelModelKind::repeat:
        return repeat(&fault.run.budget, transit);
    case ChannelModelKind::lose:
        return drop(&one, transit);
    case ChannelModelKind::repeat_last:
        return repeat_last(fault.receiver, transit);
    case ChannelModelKind::insert:
        return insert(model, &fault.run.budget, transit);
    case ChannelModelKind::masquerade:
        return masquerade(fault, transit);
    case ChannelModelKind::resequence:
        transit.choose_position(static_cast<std::uint64_t>(model.index));
        return FC_OK;
    case ChannelModelKind::block_get:
        transit.block();
        return FC_OK;
    default:
        return FC_OK; // met at a put
    }
}

} // namespace fc
