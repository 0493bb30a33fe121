// Identifiers: read once per call into words that make hashing and comparing cheap.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

namespace fc {

// A caller's identifier. Up to 16 bytes the two words and the size hold its whole content.
struct Name {
    const char *bytes;
    std::size_t size;
    std::uint64_t lo;
    std::uint64_t hi;
    std::uint64_t hash;
};

namespace name_detail {

inline std::uint64_t load64(const char *at) {
    std::uint64_t word;
    std::memcpy(&word, at, sizeof word);
    return word;
}

inline std::uint64_t load32(const char *at) {
    std::uint32_t word;
    std::memcpy(&word, at, sizeof word);
    return word;
}

inline std::uint64_t byte_at(const char *at) {
    return static_cast<unsigned char>(*at);
}

// High and low half of the full product, folded: every input bit reaches every output bit.
inline std::uint64_t fold_multiply(std::uint64_t a, std::uint64_t b) {
    __extension__ typedef unsigned __int128 Wide;
    const Wide product = static_cast<Wide>(a) * b;
    return static_cast<std::uint64_t>(product) ^ static_cast<std::uint64_t>(product >> 64);
}

constexpr std::uint64_t kMixA = 0x9e3779b97f4a7c15u;
constexpr std::uint64_t kMixB = 0xd1b54a32d192ed03u;

} // namespace name_detail

inline Name make_name(const char *bytes, std::size_t size) {
    using namespace name_detail;
    Name name{bytes, size, 0, 0, 0};
    std::uint64_t state = kMixA ^ size;
    if (size >= 4 && size <= 8) {
        name.lo = load32(bytes);
        name.hi = load32(bytes + size - 4);
    } else if (size > 8) {
        for (std::size_t at = 0; at + 16 < size; at += 16)
            state =
                fold_multiply(state ^ load64(bytes + at), kMixB ^ load64(bytes + at + 8)) + kMixA;
        name.lo = load64(bytes + (size > 16 ? size - 16 : 0));
        name.hi = load64(bytes + size - 8);
    } else if (size > 0) {
        name.lo = byte_at(bytes) | byte_at(bytes + size / 2) << 8 | byte_at(bytes + size - 1) << 16;
    }
    name.hash = fold_multiply(name.lo ^ state, name.hi ^ kMixB);
    return name;
}

inline Name read_name(const char *text) {
    return text == nullptr ? make_name("", 0) : make_name(text, std::strlen(text));
}

// An identifier kept by a record.
class StoredName {
  public:
    explicit StoredName(const Name &name)
        : lo_(name.lo), hi_(name.hi), bytes_(name.bytes, name.size), hash_(name.hash) {}

    bool equals(const Name &name) const {
        if (bytes_.size() != name.size)
            return false;
        if (name.size <= 16)
            return lo_ == name.lo && hi_ == name.hi;
        return std::memcmp(bytes_.data(), name.bytes, name.size) == 0;
    }

    std::uint64_t hash() const {
        return hash_;
    }
    const std::string &text() const {
        return bytes_;
    }

  private:
    std::uint64_t lo_;
    std::uint64_t hi_;
    std::string bytes_;
    std::uint64_t hash_;
};

} // namespace fc
