// What a fault on a value does: the model's name and its parameters.
#pragma once

#include <cstdint>

namespace fc {

enum class ModelKind : std::uint8_t {
    bitflip,
    bitflip_random,
    stuck,
    amplification,
    offset,
    set_to,
};

struct Model {
    ModelKind kind;
    std::int64_t bit = 0; // bitflip
    double value = 0;     // factor, constant, value
};

} // namespace fc
