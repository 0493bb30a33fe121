/* kernels_test.cpp: errors of the kernels in units in the last place, what they give outside their
 * range, and that a vector's lanes hold the same bits as single doubles.
 *
 * Given and expected values: test/data/copter_kernels.txt.gz, by mpmath. Where long double has 64
 * bits or more, many more arguments are compared with the C library. */
#include "kernels.h"

#include "check.h"
#include "gzip_file.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace kernels = csim_kernels;

namespace {

constexpr double allowed = 2.0;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double ulp(double x) {
    int exponent;
    std::frexp(x, &exponent);
    return std::ldexp(1.0, exponent - 53);
}

double kernel(const std::string &name, double a, double b) {
    if (name == "sin")
        return kernels::sin(a);
    if (name == "cos")
        return kernels::cos(a);
    if (name == "tan")
        return kernels::tan(a);
    if (name == "atan2")
        return kernels::atan2(a, b);
    if (name == "pow")
        return kernels::pow(a, b);
    if (name == "exp")
        return kernels::exp(a);
    if (name == "log")
        return kernels::log(a);
    return nan;
}

struct worst_case {
    double error = 0, argument = 0, second = 0;
    int count = 0;

    void see(double found, double a, double b) {
        count++;
        if (!(found <= error)) {
            error = found;
            argument = a;
            second = b;
        }
    }
};

using worst_cases = std::map<std::string, worst_case>;

void print(const char *against, const worst_cases &worst) {
    for (const auto &[name, w] : worst) {
        std::printf("%-6s %7d values against %s: at most %.3f ulp, at (%a, %a)\n", name.c_str(),
                    w.count, against, w.error, w.argument, w.second);
        CHECK(w.error <= allowed);
    }
}

void compare_with_table(const char *file) {
    worst_cases worst;
    std::istringstream lines(read_gzip(file));
    std::string line;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string name, word;
        std::vector<double> numbers;
        words >> name;
        while (words >> word) {
            numbers.push_back(std::strtod(word.c_str(), nullptr));
        }
        bool two = name == "atan2" || name == "pow";
        CHECK(numbers.size() == (two ? 4u : 3u));
        double low = numbers.back(), high = numbers[numbers.size() - 2];
        double a = numbers[0], b = two ? numbers[1] : 0.0;
        double error = std::fabs((kernel(name, a, b) - high) - low) / ulp(high);
        worst[name].see(error, a, b);
    }
    CHECK_INT(worst.size(), 7);
    print("mpmath", worst);
}

/* SplitMix64. */
struct draws {
    std::uint64_t state;

    double unit() {
        std::uint64_t z = state += 0x9E3779B97F4A7C15;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    double between(double low, double high) {
        return low + (high - low) * unit();
    }
};

using extended = long double;

const extended radians = 3.14159265358979323846264338327950288L / 180;

/* Sine and cosine of an angle in degrees; remquo is exact. */
void reference(double degrees, extended &sine, extended &cosine) {
    int quarter;
    extended y = remquol(degrees, 90, &quarter) * radians;
    extended s = sinl(y), c = cosl(y);
    bool odd = (quarter & 1) != 0;
    sine = (quarter & 2) != 0 ? -(odd ? c : s) : (odd ? c : s);
    cosine = ((quarter + 1) & 2) != 0 ? -(odd ? s : c) : (odd ? s : c);
}

void compare(worst_cases &worst, const char *name, double a, double b, extended expected) {
    extended error = fabsl(kernel(name, a, b) - expected) / ulp(static_cast<double>(expected));
    worst[name].see(static_cast<double>(error), a, b);
}

void compare_with_library() {
    if (std::numeric_limits<extended>::digits < 64) {
        std::printf("long double is no wider than double here: only the table was compared\n");
        return;
    }
    worst_cases worst;
    draws draw{7};
    for (int i = 0; i < 200000; i++) {
        double degrees = i % 2 == 0 ? draw.between(-180, 180) : draw.between(-1e5, 1e5);
        extended sine, cosine;
        reference(degrees, sine, cosine);
        compare(worst, "sin", degrees, 0, sine);
        compare(worst, "cos", degrees, 0, cosine);
        compare(worst, "tan", degrees, 0, sine / cosine);
        double y = draw.between(-10, 10), x = draw.between(-10, 10);
        compare(worst, "atan2", y, x, atan2l(y, x) / radians);
        double base = draw.between(0.5, 1.0), exponent = draw.between(0, 20);
        compare(worst, "pow", base, exponent, powl(base, exponent));
        compare(worst, "exp", exponent - 10, 0, expl(exponent - 10));
        compare(worst, "log", base, 0, logl(base));
    }
    print("the C library", worst);
}

void exact_values() {
    const double sines[] = {0, 1, 0, -1};
    for (int quarter = -400; quarter <= 400; quarter++) {
        double angle = 90.0 * quarter;
        CHECK(kernels::sin(angle) == sines[quarter & 3]);
        CHECK(kernels::cos(angle) == sines[(quarter + 1) & 3]);
    }
    CHECK(kernels::tan(45.0) == 1 && kernels::tan(-45.0) == -1 && kernels::tan(180.0) == 0);
    CHECK(kernels::tan(90.0) == 1.633123935319537e16 && kernels::tan(-90.0) == -kernels::tan(90.0));
    CHECK(kernels::pow(0.25, 0.5) == 0.5 && kernels::pow(2.0, -1074.0) == 0x1p-1074);
    for (double angle = 1e-3; angle < 1e7; angle *= 1.37) {
        CHECK(kernels::sin(-angle) == -kernels::sin(angle));
        CHECK(kernels::cos(-angle) == kernels::cos(angle));
        CHECK(kernels::tan(-angle) == -kernels::tan(angle));
    }
}

void outside_the_range() {
    for (double huge : {0x1.8p52, 1e30, 1e300, 1.7e308}) {
        CHECK(kernels::sin(huge) == 0 && kernels::cos(-huge) == 1 && kernels::tan(huge) == 0);
    }
    for (double bad : {infinity, -infinity, nan}) {
        CHECK(std::isnan(kernels::sin(bad)) && std::isnan(kernels::cos(bad)));
        CHECK(std::isnan(kernels::tan(bad)));
    }
    CHECK(std::isnan(kernels::atan2(nan, 1.0)) && std::isnan(kernels::atan2(infinity, nan)));
    CHECK(kernels::exp(1e4) == infinity && kernels::exp(-1e4) == 0);
    CHECK(kernels::exp(-infinity) == 0 && std::isnan(kernels::exp(nan)));
    CHECK(kernels::log(0.0) == -infinity && std::isnan(kernels::log(-1.0)));
    CHECK(kernels::log(infinity) == infinity && std::isnan(kernels::log(nan)));
    CHECK(std::isnan(kernels::pow(-1.0, 0.5)) && std::isnan(kernels::pow(nan, 2.0)));
}

/* C's rules, which are the same for all corners of these. */
void corners_as_in_c() {
    const double values[] = {0.0, -0.0, 1, -1, 2.5, -2.5, infinity, -infinity};
    for (double y : values) {
        for (double x : values) {
            double got = kernels::atan2(y, x), expected = std::atan2(y, x) * 180 / M_PI;
            CHECK(std::fabs(got - expected) < 1e-13 && std::signbit(got) == std::signbit(expected));
            CHECK(kernels::pow(std::fabs(y), x) == std::pow(std::fabs(y), x) ||
                  std::fabs(y) == 2.5); /* there, C's own error shows */
        }
    }
}

template <class V> void lanes_are_doubles() {
    constexpr int lanes = sizeof(V) / sizeof(double);
    const double special[] = {0.0, -0.0, infinity, -infinity, nan, 1e300, 90, -90, 45, 180};
    draws draw{11};
    for (int round = 0; round < 2000; round++) {
        alignas(64) double a[lanes], b[lanes], got[5][lanes];
        for (int i = 0; i < lanes; i++) {
            a[i] = round < 100 ? special[(round + i) % 10] : draw.between(-400, 400);
            b[i] = round < 100 ? special[(round / 10 + 3 * i) % 10] : draw.between(-400, 400);
        }
        V va, vb;
        std::memcpy(&va, a, sizeof va);
        std::memcpy(&vb, b, sizeof vb);
        kernels::direction<V> d = kernels::sin_cos(va);
        V results[5] = {d.sine, d.cosine, kernels::tan(va), kernels::atan2(va, vb),
                        kernels::sin(vb)};
        std::memcpy(got, results, sizeof got);
        for (int i = 0; i < lanes; i++) {
            double expected[5] = {kernels::sin(a[i]), kernels::cos(a[i]), kernels::tan(a[i]),
                                  kernels::atan2(a[i], b[i]), kernels::sin(b[i])};
            for (int k = 0; k < 5; k++) {
                if (!(std::isnan(expected[k]) && std::isnan(got[k][i]))) {
                    CHECK_BITS(got[k][i], expected[k]);
                }
            }
        }
    }
}

typedef double two __attribute__((vector_size(16)));
typedef double four __attribute__((vector_size(32)));
typedef double eight __attribute__((vector_size(64)));

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: kernels_test copter_kernels.txt.gz\n");
        return 2;
    }
    compare_with_table(argv[1]);
    compare_with_library();
    exact_values();
    outside_the_range();
    corners_as_in_c();
    lanes_are_doubles<two>();
    lanes_are_doubles<four>();
    lanes_are_doubles<eight>();
    return CHECK_RESULT();
}
