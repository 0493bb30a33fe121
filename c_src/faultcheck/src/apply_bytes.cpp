#include "apply.h"

#include <algorithm>

namespace fc {

namespace {

int flip(ByteSpan *bytes, std::uint64_t bit) {
    if (bit / 8 >= bytes->size)
        return FC_E_BIT;
    bytes->data[bit / 8] ^= static_cast<unsigned char>(1u << bit % 8);
    return FC_OK;
}

int flip_random(ByteSpan *bytes, RandomStream &random) {
    return bytes->size == 0 ? FC_E_BIT : flip(bytes, random.below(8 * bytes->size));
}

int force(ByteSpan *bytes, std::uint64_t bit, bool set) {
    if (bit / 8 >= bytes->size)
        return FC_E_BIT;
    const auto mask = static_cast<unsigned char>(1u << bit % 8);
    unsigned char &byte = bytes->data[bit / 8];
    byte = static_cast<unsigned char>(set ? byte | mask : byte & ~mask);
    return FC_OK;
}

int fill(ByteSpan *bytes, double value) {
    if (!(value > -1 && value < 256))
        return FC_E_VALUE;
    if (bytes->size > 0)
        std::memset(bytes->data, static_cast<int>(value), bytes->size);
    return FC_OK;
}

// A later probe call may come with another length: what was kept covers the part both have.
void restore(const std::string &kept, unsigned char *bytes, std::size_t size) {
    if (const std::size_t common = std::min(kept.size(), size); common > 0)
        std::memcpy(bytes, kept.data(), common);
}

} // namespace

void apply_stuck(const FaultCall &call, fc_type type, unsigned char *bytes, std::size_t size) {
    if (const ModelState::OfType *known = call.state.find(type))
        restore(known->held, bytes, size);
    else
        call.state.add(type, bytes, size);
}

void apply_delay(const FaultCall &call, fc_type type, unsigned char *bytes, std::size_t size) {
    const auto n = static_cast<std::uint64_t>(call.model.n);
    if (n == 0)
        return;
    ModelState::OfType *known = call.state.find(type);
    if (known == nullptr)
        known = &call.state.add(type, bytes, size);
    restore(call.state.remember(*known, n, bytes, size), bytes, size);
}

bool apply_dropout(const FaultCall &call, fc_type type, unsigned char *bytes, std::size_t size) {
    const bool dropped = call.random.unit() < call.model.a;
    ModelState::OfType *known = call.state.find(type);
    if (known == nullptr)
        known = &call.state.add(type, bytes, size);
    if (!dropped)
        known->held.assign(reinterpret_cast<const char *>(bytes), size);
    else if (call.model.n == FC_HOLD)
        restore(known->held, bytes, size);
    else if (call.model.n == FC_ZERO)
        std::memset(bytes, 0, size);
    return dropped;
}

double held_unit(const FaultCall &call, bool first) {
    const std::int64_t period = (call.inputs.now - call.state.first_time) / call.model.n;
    if (first || period != call.state.period)
        call.state.unit = call.random.unit();
    call.state.period = period;
    return call.state.unit;
}

int apply(const FaultCall &call, ByteSpan *bytes) {
    const Model &model = call.model;
    switch (model.kind) {
    case FC_BITFLIP:
        return flip(bytes, static_cast<std::uint64_t>(model.n));
    case FC_BITFLIP_RANDOM:
        return flip_random(bytes, call.random);
    case FC_STUCK_BIT:
        return force(bytes, static_cast<std::uint64_t>(model.n), model.a != 0);
    case FC_STUCK:
        apply_stuck(call, FC_BYTES, bytes->data, bytes->size);
        return FC_OK;
    case FC_DELAY:
        apply_delay(call, FC_BYTES, bytes->data, bytes->size);
        return FC_OK;
    case FC_SET_TO:
        return fill(bytes, model.a);
    default:
        return FC_E_TYPE;
    }
}

} // namespace fc
