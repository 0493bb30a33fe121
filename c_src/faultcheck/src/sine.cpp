#include "sine.h"

namespace fc {

namespace {

constexpr double kPi = 3.14159265358979323846;

// Taylor series in Horner form; the last term is below 1e-17 for |x| <= pi / 4.
double sine_series(double x) {
    const double y = x * x;
    double sum = 1;
    for (int term = 17; term >= 3; term -= 2)
        sum = 1 - y / (term * (term - 1)) * sum;
    return x * sum;
}

double cosine_series(double x) {
    const double y = x * x;
    double sum = 1;
    for (int term = 16; term >= 2; term -= 2)
        sum = 1 - y / (term * (term - 1)) * sum;
    return sum;
}

// Eighth of a turn by eighth: the argument of a series stays within pi / 4.
double sine_of_quarter(double quarter) {
    return quarter <= 0.5 ? sine_series(quarter * (kPi / 2))
                          : cosine_series((1 - quarter) * (kPi / 2));
}

} // namespace

double sine_of_turn(std::uint64_t k, std::uint64_t n) {
    __extension__ typedef unsigned __int128 Wide;
    const Wide quarters = static_cast<Wide>(k % n) * 4;
    const auto quadrant = static_cast<unsigned>(quarters / n);
    const double within =
        static_cast<double>(static_cast<std::uint64_t>(quarters % n)) / static_cast<double>(n);
    const double size = sine_of_quarter(quadrant % 2 == 0 ? within : 1 - within);
    return quadrant < 2 ? size : -size;
}

} // namespace fc
