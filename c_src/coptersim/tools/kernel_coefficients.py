#!/usr/bin/env python3
"""Writes src/generated/kernel_coefficients.h: polynomials and constants of src/kernels.h.

    kernel_coefficients.py            write to standard output

Each polynomial approximates what is left of a function when its leading terms are taken away. It interpolates that
rest, a power series with rational coefficients, in the Chebyshev nodes of the interval, which is within a small factor
of the best polynomial of its degree. All arithmetic is rational or decimal with 60 digits; only the Python standard
library is used, so the output is the same everywhere.
"""
from decimal import Decimal, getcontext
from fractions import Fraction
from math import factorial

getcontext().prec = 60
TERMS = 130  # of a power series; the slowest one falls by a factor 4 a term


def series(coefficient):
    """The function with this power series."""
    coefficients = [Decimal(c.numerator) / c.denominator for c in map(coefficient, range(TERMS))]

    def value(x):
        total = Decimal(0)
        for c in reversed(coefficients):
            total = total * x + c
        return total

    return value


def alternate(n):
    return -1 if n % 2 else 1


# name, what it is (t its argument), power series, ends of the interval, degree
POLYNOMIALS = [
    ("sin_rest", "(sin y - y) / y^3, t = y^2, |y| <= pi/4",
     lambda n: Fraction(-alternate(n), factorial(2 * n + 3)), ("0", "0.6169"), 6),
    ("cos_rest", "(cos y - 1 + y^2/2) / y^4, t = y^2, |y| <= pi/4",
     lambda n: Fraction(alternate(n), factorial(2 * n + 4)), ("0", "0.6169"), 6),
    ("atan_rest", "(atan q - q) / q^3, t = q^2, |q| <= 1/2",
     lambda n: Fraction(-alternate(n), 2 * n + 3), ("0", "0.25"), 13),
    ("exp_rest", "(exp t - 1 - t - t^2/2) / t^3, |t| <= ln(2)/2",
     lambda n: Fraction(1, factorial(n + 3)), ("-0.3467", "0.3467"), 10),
    ("atanh_rest", "(artanh s - s - s^3/3) / s^5, t = s^2, |s| <= 0.1716",
     lambda n: Fraction(1, 2 * n + 5), ("0", "0.02945"), 8),
]


def pi():
    """Machin: 16 atan(1/5) - 4 atan(1/239)."""
    def atan_inverse(k):
        return sum(Decimal(alternate(n)) / ((2 * n + 1) * Decimal(k) ** (2 * n + 1)) for n in range(TERMS))
    return 16 * atan_inverse(5) - 4 * atan_inverse(239)


def ln2():
    """2 artanh(1/3)."""
    return 2 * sum(Decimal(1) / ((2 * n + 1) * Decimal(3) ** (2 * n + 1)) for n in range(TERMS))


def cosine(x):
    return series(lambda n: Fraction(alternate(n), factorial(2 * n)))(x * x)


def nodes(low, high, count):
    """Chebyshev nodes of [low, high]."""
    middle, half, step = (low + high) / 2, (high - low) / 2, pi() / (2 * count)
    return [middle + half * cosine((2 * i + 1) * step) for i in range(count)]


def interpolate(function, points):
    """Coefficients, constant term first, by Newton's divided differences."""
    differences = [function(x) for x in points]
    for order in range(1, len(points)):
        for i in range(len(points) - 1, order - 1, -1):
            differences[i] = (differences[i] - differences[i - 1]) / (points[i] - points[i - order])
    coefficients = [Decimal(0)]
    for difference, x in zip(reversed(differences), reversed(points)):
        shifted = [Decimal(0)] + coefficients
        coefficients = [a - x * b for a, b in zip(shifted, coefficients + [Decimal(0)])]
        coefficients[0] += difference
    return coefficients[:len(points)]


def largest_error(function, coefficients, low, high):
    """Over 400 points, with the coefficients rounded to double."""
    rounded = [Decimal(float(c)) for c in coefficients]
    worst = Decimal(0)
    for i in range(401):
        x = low + (high - low) * i / 400
        total = Decimal(0)
        for c in reversed(rounded):
            total = total * x + c
        worst = max(worst, abs(total - function(x)))
    return worst


def truncated(value, bits):
    """The double below value with so many leading bits."""
    mantissa, exponent = float(value).hex().split("p")
    keep = int(mantissa[4:], 16) >> (53 - bits) << (53 - bits)
    return float.fromhex(f"0x1.{keep:013x}p{exponent}")


def constant(name, value, comment):
    high = float(value)
    low = float(value - Decimal(high))
    print(f"/* {comment}, as a sum of two doubles */")
    print(f"constexpr double {name} = {high.hex()};")
    print(f"constexpr double {name}_low = {low.hex()};")


def main():
    print("/* generated from power series by c_src/coptersim/tools/kernel_coefficients.py; do not edit */")
    print("#ifndef CSIM_KERNEL_COEFFICIENTS_H\n#define CSIM_KERNEL_COEFFICIENTS_H\n")
    print("namespace csim_kernels {\n")
    short = truncated(pi() / 180, 26)
    print("/* pi / 180, its leading 26 bits, and what they leave */")
    print(f"constexpr double radians_per_degree = {float(pi() / 180).hex()};")
    print(f"constexpr double radians_per_degree_short = {short.hex()};")
    print(f"constexpr double radians_per_degree_rest = {float(pi() / 180 - Decimal(short)).hex()};")
    constant("degrees_per_radian", 180 / pi(), "180 / pi")
    constant("ln_2", ln2(), "ln 2")
    constant("third", Decimal(1) / 3, "1 / 3")
    for name, text, coefficient, (low, high), degree in POLYNOMIALS:
        function, low, high = series(coefficient), Decimal(low), Decimal(high)
        coefficients = interpolate(function, nodes(low, high, degree + 1))
        error = largest_error(function, coefficients, low, high)
        print(f"\n/* {text}; error below {float(error):.1e} */")
        print(f"constexpr double {name}[] = {{")
        for c in coefficients:
            print(f"    {float(c).hex()},")
        print("};")
    print("\n} // namespace csim_kernels\n\n#endif")


if __name__ == "__main__":
    main()
