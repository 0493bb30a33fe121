// One fault on one value that it has been triggered for.
#pragma once

#include "arithmetic.h"
#include "model_state.h"
#include "random_stream.h"
#include "sensor_model.h"
#include "trigger.h"

#include <cstdint>
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

template <class T> void force_bit(T *value, int bit, bool set) {
    if constexpr (std::is_same_v<T, bool>) {
        *value = set;
    } else {
        typename Word<sizeof(T)>::Type word;
        std::memcpy(&word, value, sizeof word);
        const std::uint64_t mask = std::uint64_t{1} << bit;
        word = static_cast<decltype(word)>(set ? word | mask : word & ~mask);
        std::memcpy(value, &word, sizeof word);
    }
}

// What a triggered fault works with, beside the value.
struct FaultCall {
    const Model &model;
    ModelState &state;
    RandomStream &random;
    const CallInputs &inputs;
};

// Scalars, as their bytes, and whole byte runs: STUCK and DELAY do not care.
void apply_stuck(const FaultCall &call, fc_type type, unsigned char *bytes, std::size_t size);
void apply_delay(const FaultCall &call, fc_type type, unsigned char *bytes, std::size_t size);
// True when a dropout in mode HOLD, ZERO or NAN happens now; HOLD and ZERO have then changed the
// bytes.
bool apply_dropout(const FaultCall &call, fc_type type, unsigned char *bytes, std::size_t size);

template <class T> unsigned char *bytes_of(T *value) {
    return reinterpret_cast<unsigned char *>(value);
}

template <class T> int apply_dropout_to(const FaultCall &call, T *value) {
    if (call.model.n == FC_NAN && !std::is_floating_point_v<T>)
        return FC_E_TYPE;
    const bool dropped = apply_dropout(call, TypeOf<T>::value, bytes_of(value), sizeof(T));
    if constexpr (std::is_floating_point_v<T>)
        if (dropped && call.model.n == FC_NAN)
            *value = std::numeric_limits<T>::quiet_NaN();
    return FC_OK;
}

// Takes the memory that applying the model to a value may need, so that this cannot fail.
inline void prepare(const Model &model, ModelState &state, fc_type type, std::size_t size) {
    if (keeps_values(model))
        state.prepare(type, size, model.kind == FC_DELAY ? static_cast<std::uint64_t>(model.n) : 0);
}

// The window's first x of this type.
template <class T> double first_of(ModelState &state, T *value) {
    ModelState::OfType *known = state.find(TypeOf<T>::value);
    if (known == nullptr)
        known = &state.add(TypeOf<T>::value, value, sizeof(T));
    T first;
    std::memcpy(&first, known->held.data(), sizeof first);
    return static_cast<double>(first);
}

// HELD_OFFSET: draws in the first call of the window and of each period.
double held_unit(const FaultCall &call, bool first);

template <class T> int apply_sensor(const FaultCall &call, T *value) {
    SensorCall sensor{call.state.next_call(), 0, 0, 0};
    if (call.model.kind == FC_RAMP)
        sensor.first = first_of(call.state, value);
    if (sensor.k == 0)
        call.state.first_time = call.inputs.now;
    sensor.seconds = static_cast<double>(call.inputs.now - call.state.first_time) * 1e-9;
    if (call.model.kind == FC_HELD_OFFSET)
        sensor.unit = held_unit(call, sensor.k == 0);
    const double result =
        compute_sensor(call.model, sensor, call.random, static_cast<double>(*value));
    return store_result(result, value) ? FC_OK : FC_E_VALUE;
}

template <class T> __attribute__((noinline)) int apply_rare(const FaultCall &call, T *value) {
    switch (call.model.kind) {
    case FC_STUCK_BIT:
        if (call.model.n >= width_of<T>())
            return FC_E_BIT;
        force_bit(value, static_cast<int>(call.model.n), call.model.a != 0);
        return FC_OK;
    case FC_BITFLIP_RANDOM:
        flip_bit(value, static_cast<int>(call.random.below(width_of<T>())));
        return FC_OK;
    case FC_STUCK:
        apply_stuck(call, TypeOf<T>::value, bytes_of(value), sizeof(T));
        return FC_OK;
    case FC_DELAY:
        apply_delay(call, TypeOf<T>::value, bytes_of(value), sizeof(T));
        return FC_OK;
    case FC_DROPOUT:
        return apply_dropout_to(call, value);
    default:
        return apply_sensor(call, value);
    }
}

// FC_OK, or why the fault was skipped: FC_E_BIT, FC_E_VALUE, FC_E_TYPE. The plain models are
// inlined: they are what a probe in a tight loop meets.
template <class T> inline int apply(const FaultCall &call, T *value) {
    const Model &model = call.model;
    if (model.kind == FC_BITFLIP) {
        if (model.n >= width_of<T>())
            return FC_E_BIT;
        flip_bit(value, static_cast<int>(model.n));
        return FC_OK;
    }
    if (model.kind >= FC_AMPLIFICATION && model.kind <= FC_SET_TO)
        return apply_arithmetic(model, value);
    return apply_rare(call, value);
}

int apply(const FaultCall &call, ByteSpan *bytes);

} // namespace fc
