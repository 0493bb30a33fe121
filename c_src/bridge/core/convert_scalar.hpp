// Integers, floats, enums and bit-fields, each against its own range.
#pragma once

#include "error.hpp"
#include "term.hpp"
#include "type.hpp"

#include <cstdint>

namespace cb {

[[noreturn]] void bad_value(const char *what, const Type &type, TermReader &reader, Term term);

// The low bits of an integer, bool or enum of `bits` bits.
std::uint64_t integer_in(TermReader &reader, Term term, const Type &type, unsigned bits);
void integer_out(TermWriter &writer, const Type &type, std::uint64_t value, unsigned bits);
void float_in(TermReader &reader, Term term, const Type &type, void *place);
void float_out(TermWriter &writer, const Type &type, const void *place);

// `bits` bits from bit `offset` of `base` on.
std::uint64_t load_bits(const unsigned char *base, std::uint64_t offset, unsigned bits);
void store_bits(unsigned char *base, std::uint64_t offset, unsigned bits, std::uint64_t value);

} // namespace cb
