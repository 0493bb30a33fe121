// One fault on one value that it has been triggered for.
#pragma once

#include "arithmetic.h"
#include "model_state.h"
#include "random_stream.h"

#include <cstring>

namespace fc {

// A run of bytes as a probe sees it.
struct ByteSpan {
    unsigned char *data;
    std::size_t size;
};

template <class T> void flip_bit(T *value, int bit) {
    if constexpr (std::is_same_v<T, bool>) {
        *value = !*value;
    } else {
        unsigned char bytes[sizeof(T)];
        std::memcpy(bytes, value, sizeof(T));
#if __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
        bytes[bit / 8] ^= static_cast<unsigned char>(1u << bit % 8);
#else
        bytes[sizeof(T) - 1 - bit / 8] ^= static_cast<unsigned char>(1u << bit % 8);
#endif
        std::memcpy(value, bytes, sizeof(T));
    }
}

template <class T> void hold_first(ModelState &state, T *value) {
    if (const std::string *held = state.held(TypeOf<T>::value))
        std::memcpy(value, held->data(), sizeof(T));
    else
        state.hold(TypeOf<T>::value, value, sizeof(T));
}

// FC_OK, or why the fault was skipped: FC_E_BIT, FC_E_VALUE.
template <class T>
int apply(const Model &model, ModelState &state, RandomStream &random, T *value) {
    switch (model.kind) {
    case ModelKind::bitflip:
        if (model.bit >= width_of<T>())
            return FC_E_BIT;
        flip_bit(value, static_cast<int>(model.bit));
        return FC_OK;
    case ModelKind::bitflip_random:
        flip_bit(value, static_cast<int>(random.below(width_of<T>())));
        return FC_OK;
    case ModelKind::stuck:
        hold_first(state, value);
        return FC_OK;
    default:
        return apply_arithmetic(model, value);
    }
}

// FC_OK, or why the fault was skipped: FC_E_BIT, FC_E_VALUE, FC_E_TYPE.
int apply(const Model &model, ModelState &state, RandomStream &random, ByteSpan *bytes);

} // namespace fc
