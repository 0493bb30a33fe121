// The stream of random numbers a fault owns: SplitMix64, the same on every platform.
#pragma once

#include <cstdint>
#include <string>

namespace fc {

inline std::uint64_t fnv1a64(const std::string &bytes) {
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const char byte : bytes)
        hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
    return hash;
}

class RandomStream {
  public:
    RandomStream() = default;
    // ordinal: how many faults the identifier had been given before this one.
    RandomStream(std::uint64_t seed, const std::string &identifier, std::uint64_t ordinal)
        : state_(seed ^ fnv1a64(identifier) ^ (ordinal * kGamma)) {}

    std::uint64_t next() {
        state_ += kGamma;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    // 0 .. n-1
    std::uint64_t below(std::uint64_t n) {
        __extension__ typedef unsigned __int128 Wide;
        return static_cast<std::uint64_t>((static_cast<Wide>(next()) * n) >> 64);
    }

    // 0 <= unit < 1
    double unit() {
        return static_cast<double>(next() >> 11) * 0x1p-53;
    }

    // Mean 0, variance 1; the sum of uniform numbers needs no libm.
    double gauss() {
        double sum = 0;
        for (int i = 0; i < 12; ++i)
            sum += unit();
        return sum - 6;
    }

  private:
    static constexpr std::uint64_t kGamma = 0x9e3779b97f4a7c15u;
    std::uint64_t state_ = 0;
};

} // namespace fc
