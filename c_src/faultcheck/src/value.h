// Typed values: widths, limits, and the conversion of a computed result back to the probed type.
#pragma once

#include "fc.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace fc {

__extension__ typedef __int128 Int128;

template <class T> struct TypeOf;
template <> struct TypeOf<float> { static constexpr fc_type value = FC_F32; };
template <> struct TypeOf<double> { static constexpr fc_type value = FC_F64; };
template <> struct TypeOf<std::int8_t> { static constexpr fc_type value = FC_I8; };
template <> struct TypeOf<std::int16_t> { static constexpr fc_type value = FC_I16; };
template <> struct TypeOf<std::int32_t> { static constexpr fc_type value = FC_I32; };
template <> struct TypeOf<std::int64_t> { static constexpr fc_type value = FC_I64; };
template <> struct TypeOf<std::uint8_t> { static constexpr fc_type value = FC_U8; };
template <> struct TypeOf<std::uint16_t> { static constexpr fc_type value = FC_U16; };
template <> struct TypeOf<std::uint32_t> { static constexpr fc_type value = FC_U32; };
template <> struct TypeOf<std::uint64_t> { static constexpr fc_type value = FC_U64; };
template <> struct TypeOf<bool> { static constexpr fc_type value = FC_BOOL; };
struct ByteSpan;
template <> struct TypeOf<ByteSpan> { static constexpr fc_type value = FC_BYTES; };

constexpr int kTypeCount = FC_BYTES + 1;

template <class T> constexpr int width_of() {
    return std::is_same_v<T, bool> ? 1 : 8 * static_cast<int>(sizeof(T));
}

// Truncated toward zero and saturated at the type's limits. result is not NaN.
template <class T> T saturate(double result) {
    // 2^digits is the first value above the limits and is a double without rounding.
    constexpr int digits = std::numeric_limits<T>::digits;
    constexpr double above =
        digits == 64 ? 0x1p64 : static_cast<double>(std::uint64_t{1} << (digits % 64));
    // For int64 the subtraction rounds back to the limit itself, which is right as well.
    constexpr double below = static_cast<double>(std::numeric_limits<T>::min()) - 1;
    if (result >= above)
        return std::numeric_limits<T>::max();
    if (result <= below)
        return std::numeric_limits<T>::min();
    return static_cast<T>(result);
}

template <class T> T saturate(Int128 result) {
    if (result > static_cast<Int128>(std::numeric_limits<T>::max()))
        return std::numeric_limits<T>::max();
    if (result < static_cast<Int128>(std::numeric_limits<T>::min()))
        return std::numeric_limits<T>::min();
    return static_cast<T>(result);
}

// A computed result as the probed type. False when it is not a number and the type has none.
template <class T> bool store_result(double result, T *value) {
    if constexpr (std::is_floating_point_v<T>) {
        *value = static_cast<T>(result);
        return true;
    } else {
        if (std::isnan(result))
            return false;
        if constexpr (std::is_same_v<T, bool>)
            *value = result != 0;
        else
            *value = saturate<T>(result);
        return true;
    }
}

} // namespace fc
