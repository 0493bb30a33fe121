/* kernels.h: sine, cosine, tangent and arctangent of angles in degrees, with the same bits on every
 * machine.
 *
 * A kernel works on a double, or on a vector of doubles (GCC's and clang's vector_size attribute);
 * each lane of a vector gets the bits that the double gets. There is no branch and no call, only
 * + - * / (one rounding each, so sources that use a kernel are compiled with -ffp-contract=off and
 * without -ffast-math), comparisons and operations on bits. A loop over an array of doubles is
 * vectorised by the compiler as well; it may want -fno-trapping-math for it. Vectors wider than the
 * build's registers work, but compilers then want -Wno-psabi to hear that none is passed on.
 *
 * Errors are below 2 units in the last place over all finite arguments stated at the function
 * (test/kernels_test.cpp measures about 1). NaN gives NaN; infinite angles give NaN. An angle
 * beyond 2^52 degrees, where doubles no longer tell half turns apart well, counts as 0: a fault
 * that makes an angle huge gives a finite result.
 *
 * pow, exp and log are needed once a run and are plain functions. */
#ifndef CSIM_KERNELS_H
#define CSIM_KERNELS_H

#include "generated/kernel_coefficients.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

/* Internal linkage and always inlined: a build for one instruction set never runs another's code.*/
#define CSIM_KERNEL static inline __attribute__((always_inline))

namespace csim_kernels {

/* b to the power of y, b >= 0. */
double pow(double b, double y);
/* Overflows to infinity, underflows gradually to 0. */
double exp(double x);
/* -infinity at 0, NaN below. */
double log(double x);

/* ---- Bits of doubles, one or a vector of them ---- */

template <class V> struct lane_bits {
    using type = decltype(std::declval<V>() < std::declval<V>());
};
template <> struct lane_bits<double> { using type = std::int64_t; };
/* As many 64-bit integers as V has doubles. */
template <class V> using bits_t = typename lane_bits<V>::type;

constexpr std::int64_t sign_bit = INT64_MIN;

template <class V> CSIM_KERNEL bits_t<V> bits(V x) {
    bits_t<V> result;
    std::memcpy(&result, &x, sizeof result);
    return result;
}

template <class V> CSIM_KERNEL V real(bits_t<V> x) {
    V result;
    std::memcpy(&result, &x, sizeof result);
    return result;
}

template <class V> CSIM_KERNEL V fill(double value) {
    return V{} + value;
}

template <class V> CSIM_KERNEL V magnitude(V x) {
    return real<V>(bits(x) & ~sign_bit);
}

/* x, negated where sign has the sign bit. */
template <class V> CSIM_KERNEL V flip_sign(V x, V sign) {
    return real<V>(bits(x) ^ (bits(sign) & sign_bit));
}

/* a where every bit of choose is set, b where none is. */
template <class V> CSIM_KERNEL V blend(bits_t<V> choose, V a, V b) {
    return real<V>((bits(a) & choose) | (bits(b) & ~choose));
}

/* The leading 26 bits. */
template <class V> CSIM_KERNEL V leading(V x) {
    return real<V>(bits(x) & -(std::int64_t{1} << 27));
}

/* ---- Sums of two doubles: high is the rounded value, low what it lacks ---- */

template <class V> struct pair { V high, low; };

/* |a| >= |b|, or a = 0. */
template <class V> CSIM_KERNEL pair<V> sum(V a, V b) {
    V high = a + b;
    return {high, (a - high) + b};
}

/* Exact unless it over- or underflows. */
template <class V> CSIM_KERNEL pair<V> product(V a, V b) {
    V high = a * b;
    V a1 = leading(a), b1 = leading(b);
    V a2 = a - a1, b2 = b - b1;
    return {high, (((a1 * b1 - high) + a1 * b2) + a2 * b1) + a2 * b2};
}

template <class V, std::size_t n> CSIM_KERNEL V polynomial(const double (&coefficients)[n], V x) {
    V value = fill<V>(coefficients[n - 1]);
    for (std::size_t i = n - 1; i-- > 0;) {
        value = value * x + coefficients[i];
    }
    return value;
}

/* ---- Reduction ---- */

/* Adding it leaves the nearest integer in the lowest bits. */
constexpr double round_magic = 0x1.8p52;
constexpr double largest_angle = 0x1p52;

/* angle = 90 quarter + r degrees, |r| <= 45, where y is r in radians. */
template <class V> struct reduced {
    pair<V> y;
    bits_t<V> quarter; /* only its two lowest bits mean anything */
};

template <class V> CSIM_KERNEL reduced<V> reduce(V degrees) {
    V known = magnitude(degrees) <= largest_angle ? degrees : degrees * 0.0;
    V shifted = known * (1.0 / 90) + round_magic;
    V r = known - (shifted - round_magic) * 90.0; /* both exact */
    V r1 = leading(r);
    V r2 = r - r1;
    pair<V> y =
        sum(r1 * radians_per_degree_short, r2 * radians_per_degree + r1 * radians_per_degree_rest);
    return {y, bits(shifted)};
}

/* Sine and cosine of y, |y| <= pi/4, each as a sum of two. */
template <class V> struct wave { pair<V> sine, cosine; };

template <class V> CSIM_KERNEL wave<V> wave_of(pair<V> y) {
    V z = y.high * y.high;
    V half = 0.5 * z;
    V one = fill<V>(1.0);
    V first = one - half;
    V cosine_rest = ((one - first) - half) + (z * z * polynomial(cos_rest, z) - y.high * y.low);
    V sine_rest = y.low * first + y.high * (z * polynomial(sin_rest, z));
    return {{y.high, sine_rest}, {first, cosine_rest}};
}

/* ---- The kernels ---- */

template <class V> struct direction { V sine, cosine; };

/* Sine and cosine of an angle in degrees. Exact at multiples of 90. */
template <class V> CSIM_KERNEL direction<V> sin_cos(V degrees) {
    reduced<V> angle = reduce(degrees);
    wave<V> w = wave_of(angle.y);
    V s = w.sine.high + w.sine.low;
    V c = w.cosine.high + w.cosine.low;
    bits_t<V> odd = -(angle.quarter & 1);
    V sine_sign = real<V>((angle.quarter & 2) << 62);
    V cosine_sign = real<V>(((angle.quarter + 1) & 2) << 62);
    return {flip_sign(blend(odd, c, s), sine_sign), flip_sign(blend(odd, s, c), cosine_sign)};
}

template <class V> CSIM_KERNEL V sin(V degrees) {
    return sin_cos(degrees).sine;
}

template <class V> CSIM_KERNEL V cos(V degrees) {
    return sin_cos(degrees).cosine;
}

/* The cosine of the double nearest to pi/2: what the tangent divides by at 90 degrees. */
constexpr double cosine_at_pole = 0x1.1a62633145c07p-54;

/* Tangent of an angle in degrees. At odd multiples of 90 degrees it is 1.633123935319537e16 with
 * the sign of the angle, the tangent of the double nearest to pi/2, and not infinite. */
template <class V> CSIM_KERNEL V tan(V degrees) {
    reduced<V> angle = reduce(degrees);
    wave<V> w = wave_of(angle.y);
    pair<V> s = sum(w.sine.high, w.sine.low);
    pair<V> c = sum(w.cosine.high, w.cosine.low);
    bits_t<V> odd = -(angle.quarter & 1);
    pair<V> over = {blend(odd, c.high, s.high), blend(odd, c.low, s.low)};
    pair<V> under = {blend(odd, -s.high, c.high), blend(odd, -s.low, c.low)};
    V pole = flip_sign(fill<V>(cosine_at_pole), degrees);
    under.high = under.high == 0.0 ? pole : under.high;
    V inverse = 1.0 / under.high;
    V quotient = over.high * inverse;
    pair<V> back = product(quotient, under.high);
    V missing = ((over.high - back.high) - back.low) + (over.low - quotient * under.low);
    return quotient + missing * inverse;
}

/* The direction of (x, y) in degrees, -180 to 180, as C's atan2 tells it: 0 or 180 with the sign
 * of y where y is 0, multiples of 45 for infinities. */
template <class V> CSIM_KERNEL V atan2(V y, V x) {
    V zero = V{}, one = fill<V>(1.0);
    V ax = magnitude(x), ay = magnitude(y);
    auto steep = ay > ax;
    V large = steep ? ay : ax;
    V small = steep ? ax : ay;
    V unit = large * 0.0 == 0.0 ? zero : one; /* infinite (or NaN): only infinity counts */
    V scale = large > 0x1p1000 ? fill<V>(0.25) : one;
    scale = large < 0x1p-400 ? fill<V>(0x1p600) : scale;
    small = unit == 0.0 ? small * scale : (small == large ? one : small - small);
    large = unit == 0.0 ? large * scale : (large == large ? one : large);
    large = large == 0.0 ? one : large; /* (0, 0) */

    /* atan(small / large), or 45 degrees more than atan((small - large) / (small + large)) */
    auto middle = small > 0.5 * large;
    V over = middle ? small - large : small;
    pair<V> both = sum(large, small);
    pair<V> under = {middle ? both.high : large, middle ? both.low : zero};
    V q = over / under.high;
    pair<V> back = product(q, under.high);
    V q_low = (((over - back.high) - back.low) - q * under.low) / under.high;
    V z = q * q;
    pair<V> scaled = product(q, fill<V>(degrees_per_radian));
    V rest = scaled.low + q * degrees_per_radian_low +
             degrees_per_radian * (q_low * (one - z) + q * (z * polynomial(atan_rest, z)));

    /* The octants: each step adds a multiple of 45 exactly, up to the last rounding. */
    V base = middle ? fill<V>(45.0) : zero;
    V sign = one;
    base = steep ? 90.0 - base : base;
    sign = steep ? -sign : sign;
    auto left = bits(x) < 0;
    base = left ? 180.0 - base : base;
    sign = left ? -sign : sign;
    pair<V> angle = sum(base, sign * scaled.high);
    return flip_sign(angle.high + (angle.low + sign * rest), y);
}

} // namespace csim_kernels

#endif
