// Between terms and C values. Every value is checked against its C type before a byte is written.
#pragma once

#include "arena.hpp"
#include "pointers.hpp"
#include "term.hpp"
#include "type.hpp"

namespace cb {

// What conversion needs besides the value: pointers by reference, functions by name, types by
// spelling.
class ConversionContext {
  public:
    virtual ~ConversionContext() = default;
    virtual PointerTable &pointers() = 0;
    // Throws Error when there is no such function or it cannot be called.
    virtual void *function_address(const std::string &name) = 0;
    // Throws Error {unknown_type, CType}.
    virtual const Type &type_named(const std::string &spelling) = 0;
};

struct Pointer {
    unsigned char *address = nullptr;
    const Type *pointee = nullptr;
    std::size_t bytes = 0; // as PointerTable::Entry
};

// `null` or {ptr, CType, Ref}. Throws Error {stale_pointer, P} or {bad_pointer, Term}.
Pointer read_pointer(ConversionContext &context, TermReader &reader, Term term);
// True for null and for a tuple that starts with `ptr`.
bool looks_like_pointer(TermReader &reader, Term term);
void write_pointer(ConversionContext &context, TermWriter &writer, void *address,
                   const Type &pointee);

// Writes the value to `place` (type.size bytes). Buffers that pointers need come from `arena`.
// Throws ValueError, and Error for stale pointers.
void value_in(ConversionContext &context, TermReader &reader, Term term, const Type &type,
              void *place, Arena &arena);
// A bit-field or whole member at a bit offset of `base`.
void member_in(ConversionContext &context, TermReader &reader, Term term, const Member &member,
               unsigned char *base, Arena &arena);

void value_out(ConversionContext &context, TermWriter &writer, const Type &type, const void *place);
void member_out(ConversionContext &context, TermWriter &writer, const Member &member,
                const unsigned char *base);

} // namespace cb
