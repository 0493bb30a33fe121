/* kernels.cpp: pow, exp and log, once a run. Logarithms are sums of two doubles with about 100
 * correct bits less those of the polynomial's share: relative error below 2^-64. */
#include "kernels.h"

#include <limits>

namespace csim_kernels {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using number = pair<double>;

number plus(number a, number b) {
    double high = a.high + b.high;
    double back = high - a.high;
    double lost = (a.high - (high - back)) + (b.high - back);
    return sum(high, lost + (a.low + b.low));
}

number times(number a, number b) {
    number p = product(a.high, b.high);
    return sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

/* The nearest quotient, and one correction. */
number over(number a, number b) {
    double q = a.high / b.high;
    number back = times({q, 0.0}, b);
    return sum(q, (((a.high - back.high) - back.low) + a.low) / b.high);
}

/* x = m 2^e with m from sqrt(1/2) to sqrt(2); x positive and finite. */
struct scaled {
    double m;
    double e;
};

scaled split(double x) {
    double extra = x < 0x1p-1022 ? 54 : 0;
    std::int64_t word = bits(x < 0x1p-1022 ? x * 0x1p54 : x);
    constexpr std::int64_t root_half = 0x3fe6a09e667f3bcd; /* bits of sqrt(1/2) */
    constexpr std::int64_t exponent_of_one = std::int64_t{1023} << 52;
    std::int64_t e = ((word - root_half) >> 52);
    double m = real<double>(word - e * (std::int64_t{1} << 52));
    static_assert(root_half < exponent_of_one, "m reaches above 1");
    return {m, static_cast<double>(e) - extra};
}

/* ln x = e ln 2 + 2 artanh s, s = (m - 1) / (m + 1). */
number log_of(double x) {
    scaled parts = split(x);
    number s = over({parts.m - 1.0, 0.0},
                    sum(parts.m > 1.0 ? parts.m : 1.0, parts.m > 1.0 ? 1.0 : parts.m));
    number z = times(s, s);
    number series = sum(third, third_low + z.high * polynomial(atanh_rest, z.high));
    number artanh = plus(s, times(times(s, z), series));
    number whole = times({ln_2, ln_2_low}, {parts.e, 0.0});
    return plus(whole, {2.0 * artanh.high, 2.0 * artanh.low});
}

/* 2^k for -2044 <= k <= 2046, as two factors so that the result is rounded once. */
double scale(double x, std::int64_t k) {
    std::int64_t half = k / 2;
    double first = real<double>((half + 1023) << 52);
    double second = real<double>((k - half + 1023) << 52);
    return x * first * second;
}

/* exp(x) with |x| < 1400. */
double exp_of(number x) {
    double shifted = x.high * (1.0 / ln_2) + round_magic;
    double k = shifted - round_magic;
    number whole = times({ln_2, ln_2_low}, {-k, 0.0});
    number r = plus(x, whole);
    double square = r.high * r.high;
    double rest = r.low + (0.5 * square + square * (r.high * polynomial(exp_rest, r.high)));
    number near_one = sum(1.0, r.high);
    return scale(near_one.high + (near_one.low + rest), static_cast<std::int64_t>(k));
}

} // namespace

double exp(double x) {
    if (x != x) {
        return x;
    }
    double inside = x > 1000.0 ? 1000.0 : (x < -1000.0 ? -1000.0 : x);
    return exp_of({inside, 0.0});
}

double log(double x) {
    if (!(x > 0.0)) {
        return x == 0.0 ? -infinity : nan;
    }
    if (x == infinity) {
        return x;
    }
    number result = log_of(x);
    return result.high + result.low;
}

double pow(double b, double y) {
    if (y == 0.0 || b == 1.0) {
        return 1.0;
    }
    if (!(b >= 0.0) || y != y) {
        return nan;
    }
    if (b == 0.0 || b == infinity) {
        return (b == 0.0) == (y > 0.0) ? 0.0 : infinity;
    }
    number exponent = log_of(b);
    double estimate = exponent.high * y;
    if (!(magnitude(estimate) < 1000.0)) {
        return estimate > 0.0 ? infinity : 0.0;
    }
    return exp_of(times(exponent, {y, 0.0}));
}

} // namespace csim_kernels
