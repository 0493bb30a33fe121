// Sine of a fraction of a full turn, from additions and multiplications only: the same bits on
// every platform.
#pragma once

#include <cstdint>

namespace fc {

// sin(2 * pi * k / n), n > 0.
double sine_of_turn(std::uint64_t k, std::uint64_t n);

} // namespace fc
