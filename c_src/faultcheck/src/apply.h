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

// The unsigned integer of a type's size.
template <std::size_t Size> struct Word;
template <> struct Word<1> { using Type = std::uint8_t; };
template <> struct Word<2> { using Type = std::uint16_t; };
template <> struct Word<4> { using Type = std::uint32_t; };
template <> struct Word<8> { using Type = std::uint64_t; };

template <class T> void flip_bit(T *value, int bit) {
    if constexpr (std::is_same_v<T, bool>) {
        *value = !*value;
    } else {
        typename Word<sizeof(T)>::Type word;
        std::memcpy(&word, value, sizeof word);
        word = static_cast<decltype(word)>(word ^ std::uint64_t{1} << bit);
        std::memcpy(value, &word, sizeof word);
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
