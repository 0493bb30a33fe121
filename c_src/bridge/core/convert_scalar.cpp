#include "convert_scalar.hpp"

#include "names.hpp"

#include <cfloat>
#include <cmath>
#include <cstring>
#include <limits>

namespace cb {

void bad_value(const char *what, const Type &type, TermReader &reader, Term term) {
    throw ValueError(Tree::tuple(
        {Tree::atom(what), Tree::atom(type.spelling.text()), Tree::foreign(reader, term)}));
}

namespace {

std::uint64_t mask(unsigned bits) {
    return bits >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << bits) - 1;
}

bool is_signed(const Type &type) {
    return type.kind == Kind::Signed || (type.kind == Kind::Enum && type.is_signed);
}

std::uint64_t number_in(TermReader &reader, Term term, const Type &type, unsigned bits) {
    std::int64_t number = 0;
    if (reader.read_signed(term, number)) {
        if (is_signed(type)) {
            const auto limit = static_cast<std::int64_t>(mask(bits - 1));
            if (number >= -limit - 1 && number <= limit) {
                return static_cast<std::uint64_t>(number) & mask(bits);
            }
        } else if (number >= 0 && static_cast<std::uint64_t>(number) <= mask(bits)) {
            return static_cast<std::uint64_t>(number);
        }
        bad_value("out_of_range", type, reader, term);
    }
    std::uint64_t wide = 0;
    if (reader.read_unsigned(term, wide) && !is_signed(type) && wide <= mask(bits)) {
        return wide;
    }
    const bool integer = reader.kind(term) == TermKind::Integer;
    bad_value(integer ? "out_of_range" : "bad_type", type, reader, term);
}

} // namespace

std::uint64_t integer_in(TermReader &reader, Term term, const Type &type, unsigned bits) {
    if (type.kind == Kind::Bool) {
        if (reader.is_atom(term, names::true_)) {
            return 1;
        }
        if (reader.is_atom(term, names::false_)) {
            return 0;
        }
        return number_in(reader, term, type, 1);
    }
    if (type.kind == Kind::Enum && reader.kind(term) == TermKind::Atom) {
        for (const Enumerator &enumerator : type.enumerators) {
            if (reader.is_atom(term, enumerator.name)) {
                return static_cast<std::uint64_t>(enumerator.value) & mask(bits);
            }
        }
        bad_value("bad_enumerator", type, reader, term);
    }
    return number_in(reader, term, type, bits);
}

void integer_out(TermWriter &writer, const Type &type, std::uint64_t value, unsigned bits) {
    if (type.kind == Kind::Bool) {
        return writer.write_name(value != 0 ? names::true_ : names::false_);
    }
    auto number = static_cast<std::int64_t>(value);
    if (is_signed(type) && bits < 64) {
        number = static_cast<std::int64_t>(value << (64 - bits)) >> (64 - bits);
    }
    if (type.kind == Kind::Enum) {
        for (const Enumerator &enumerator : type.enumerators) {
            if (enumerator.value == number) {
                return writer.write_name(enumerator.name);
            }
        }
    }
    if (is_signed(type)) {
        writer.write_signed(number);
    } else {
        writer.write_unsigned(value);
    }
}

namespace {

double special_float(TermReader &reader, Term term, const Type &type) {
    if (reader.is_atom(term, names::nan)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    if (reader.is_atom(term, names::inf)) {
        return std::numeric_limits<double>::infinity();
    }
    if (reader.is_atom(term, names::neg_inf)) {
        return -std::numeric_limits<double>::infinity();
    }
    const bool integer = reader.kind(term) == TermKind::Integer; // one beyond 64 bits
    bad_value(integer ? "out_of_range" : "bad_type", type, reader, term);
}

double number_in(TermReader &reader, Term term, const Type &type) {
    double value = 0;
    std::int64_t integer = 0;
    std::uint64_t wide = 0;
    if (reader.read_float(term, value)) {
        return value;
    }
    if (reader.read_signed(term, integer)) {
        return static_cast<double>(integer);
    }
    if (reader.read_unsigned(term, wide)) {
        return static_cast<double>(wide);
    }
    return special_float(reader, term, type);
}

} // namespace

void float_in(TermReader &reader, Term term, const Type &type, void *place) {
    const double value = number_in(reader, term, type);
    if (type.size == sizeof(float)) {
        // Half a unit beyond the largest float still rounds to it.
        if (std::isfinite(value) && std::fabs(value) >= 0x1.ffffffp127) {
            bad_value("out_of_range", type, reader, term);
        }
        const auto narrow = static_cast<float>(value);
        std::memcpy(place, &narrow, sizeof narrow);
    } else if (type.size == sizeof(double)) {
        std::memcpy(place, &value, sizeof value);
    } else {
        const auto extended = static_cast<long double>(value);
        std::memcpy(place, &extended, sizeof extended);
    }
}

void float_out(TermWriter &writer, const Type &type, const void *place) {
    double value = 0;
    if (type.size == sizeof(float)) {
        float narrow = 0;
        std::memcpy(&narrow, place, sizeof narrow);
        value = static_cast<double>(narrow);
    } else if (type.size == sizeof(double)) {
        std::memcpy(&value, place, sizeof value);
    } else {
        long double extended = 0;
        std::memcpy(&extended, place, sizeof extended);
        value = static_cast<double>(extended);
    }
    if (std::isnan(value)) {
        writer.write_name(names::nan);
    } else if (std::isinf(value)) {
        writer.write_name(value > 0 ? names::inf : names::neg_inf);
    } else {
        writer.write_float(value);
    }
}

std::uint64_t load_bits(const unsigned char *base, std::uint64_t offset, unsigned bits) {
    const unsigned char *first = base + offset / 8;
    const unsigned shift = offset % 8;
    const unsigned bytes = (shift + bits + 7) / 8; // up to 9
    std::uint64_t low = 0;
    std::memcpy(&low, first, bytes < 8 ? bytes : 8);
    std::uint64_t value = low >> shift;
    if (bytes == 9) {
        value |= static_cast<std::uint64_t>(first[8]) << (64 - shift);
    }
    return value & mask(bits);
}

void store_bits(unsigned char *base, std::uint64_t offset, unsigned bits, std::uint64_t value) {
    for (unsigned i = 0; i < bits; ++i) {
        unsigned char &byte = base[(offset + i) / 8];
        const auto bit = static_cast<unsigned char>(1U << (offset + i) % 8);
        byte = static_cast<unsigned char>((value >> i & 1U) != 0 ? byte | bit : byte & ~bit);
    }
}

} // namespace cb
