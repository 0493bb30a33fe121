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

// A later probe call may come with another length: what is held covers the part both have.
int hold_first(ModelState &state, ByteSpan *bytes) {
    if (const std::string *held = state.held(FC_BYTES))
        std::memcpy(bytes->data, held->data(), std::min(held->size(), bytes->size));
    else
        state.hold(FC_BYTES, bytes->data, bytes->size);
    return FC_OK;
}

int fill(ByteSpan *bytes, double value) {
    if (!(value > -1 && value < 256))
        return FC_E_VALUE;
    std::memset(bytes->data, static_cast<int>(value), bytes->size);
    return FC_OK;
}

} // namespace

int apply(const Model &model, ModelState &state, RandomStream &random, ByteSpan *bytes) {
    switch (model.kind) {
    case ModelKind::bitflip:
        return flip(bytes, static_cast<std::uint64_t>(model.bit));
    case ModelKind::bitflip_random:
        return flip_random(bytes, random);
    case ModelKind::stuck:
        return hold_first(state, bytes);
    case ModelKind::set_to:
        return fill(bytes, model.value);
    case ModelKind::amplification:
    case ModelKind::offset:
        break;
    }
    return FC_E_TYPE;
}

} // namespace fc
