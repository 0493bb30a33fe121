// The numeric models on one value: OFFSET, AMPLIFICATION and SET_TO.
//
// Computed in double, one operation per fault, then converted. 64-bit integers with an integral
// parameter are computed exactly instead.
#pragma once

#include "model.h"
#include "value.h"

#include <cstdint>

namespace fc {

inline double compute(const Model &model, double x) {
    switch (model.kind) {
    case FC_OFFSET:
        return x + model.a;
    case FC_AMPLIFICATION:
        return x * model.a;
    default:
        return model.a;
    }
}

// A whole number that leaves sums and products with a 64-bit value within 128 bits. A factor from
// 2^63 up gives the same through double: its product with any number but 0 and 1 is saturated.
inline bool is_exact_operand(const Model &model) {
    const double most = model.kind == FC_AMPLIFICATION ? 0x1p63 : 0x1p64;
    return model.a > -most && model.a < most && model.a == std::trunc(model.a);
}

inline Int128 compute_exact(const Model &model, Int128 x) {
    const auto operand = static_cast<Int128>(model.a);
    switch (model.kind) {
    case FC_OFFSET:
        return x + operand;
    case FC_AMPLIFICATION:
        return x * operand;
    default:
        return operand;
    }
}

// FC_OK, or FC_E_VALUE with the value left as it was.
template <class T> int apply_arithmetic(const Model &model, T *value) {
    if constexpr (std::is_integral_v<T> && sizeof(T) == 8) {
        if (is_exact_operand(model)) {
            *value = saturate<T>(compute_exact(model, static_cast<Int128>(*value)));
            return FC_OK;
        }
    }
    return store_result(compute(model, static_cast<double>(*value)), value) ? FC_OK : FC_E_VALUE;
}

} // namespace fc
