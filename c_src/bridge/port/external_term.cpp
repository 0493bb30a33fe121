#include "external_term.hpp"

#include <cstdint>

namespace cb {

namespace {

constexpr unsigned kDeepest = 256;

class Walker {
  public:
    Walker(const char *bytes, std::size_t size, std::size_t offset)
        : bytes_(reinterpret_cast<const unsigned char *>(bytes)), size_(size), at_(offset) {}

    void term(unsigned depth);
    std::size_t at() const {
        return at_;
    }

  private:
    void skip(std::uint64_t count) {
        if (count > size_ - at_) {
            throw MalformedTerm("a term is cut off", at_);
        }
        at_ += count;
    }
    std::uint64_t number(unsigned bytes) {
        const std::size_t from = at_;
        skip(bytes);
        std::uint64_t value = 0;
        for (unsigned i = 0; i < bytes; ++i) {
            value = value << 8 | bytes_[from + i];
        }
        return value;
    }
    void terms(std::uint64_t count, unsigned depth) {
        if (count > size_ - at_) { // each takes a byte at least
            throw MalformedTerm("a term is cut off", at_);
        }
        for (; count > 0; --count) {
            term(depth + 1);
        }
    }

    const unsigned char *bytes_;
    std::size_t size_;
    std::size_t at_;
};

// Tags by their numbers in the Erlang documentation, "External Term Format".
void Walker::term(unsigned depth) {
    if (depth > kDeepest) {
        throw MalformedTerm("a term is nested too deeply", at_);
    }
    const std::size_t start = at_;
    switch (number(1)) {
    case 97: // SMALL_INTEGER_EXT
        return skip(1);
    case 98: // INTEGER_EXT
        return skip(4);
    case 70: // NEW_FLOAT_EXT
        return skip(8);
    case 99: // FLOAT_EXT
        return skip(31);
    case 100: // ATOM_EXT
    case 118: // ATOM_UTF8_EXT
    case 107: // STRING_EXT
        return skip(number(2));
    case 115: // SMALL_ATOM_EXT
    case 119: // SMALL_ATOM_UTF8_EXT
        return skip(number(1));
    case 104: // SMALL_TUPLE_EXT
        return terms(number(1), depth);
    case 105: // LARGE_TUPLE_EXT
        return terms(number(4), depth);
    case 106: // NIL_EXT
        return;
    case 108: { // LIST_EXT: elements and tail
        const std::uint64_t count = number(4);
        terms(count, depth);
        return term(depth + 1);
    }
    case 109: // BINARY_EXT
        return skip(number(4));
    case 77: // BIT_BINARY_EXT
        return skip(number(4) + 1);
    case 110: // SMALL_BIG_EXT
        return skip(number(1) + 1);
    case 111: // LARGE_BIG_EXT
        return skip(number(4) + 1);
    case 116: { // MAP_EXT
        const std::uint64_t pairs = number(4);
        return terms(2 * pairs, depth);
    }
    case 88: // NEW_PID_EXT
        term(depth + 1);
        return skip(12);
    case 89: // NEW_PORT_EXT
        term(depth + 1);
        return skip(8);
    case 120: // V4_PORT_EXT
        term(depth + 1);
        return skip(12);
    case 90: { // NEWER_REFERENCE_EXT
        const std::uint64_t words = number(2);
        term(depth + 1);
        return skip(4 + 4 * words);
    }
    case 112: { // NEW_FUN_EXT: its size counts itself
        const std::uint64_t size = number(4);
        if (size < 4) {
            throw MalformedTerm("a fun of impossible size", start);
        }
        return skip(size - 4);
    }
    case 113: // EXPORT_EXT
        return terms(3, depth);
    default:
        throw MalformedTerm("unknown tag " + std::to_string(bytes_[start]), start);
    }
}

} // namespace

std::size_t end_of_term(const char *bytes, std::size_t size, std::size_t offset) {
    if (offset > size) {
        throw MalformedTerm("a term is cut off", size);
    }
    Walker walker(bytes, size, offset);
    walker.term(0);
    return walker.at();
}

} // namespace cb
