// Buffers for the library, and reading what pointers point to.
#include "session.hpp"

#include "error.hpp"

#include <algorithm>
#include <cstring>

namespace cb {

Pointer Session::checked_pointer(TermReader &reader, Term term) {
    const Pointer pointer = read_pointer(*this, reader, term);
    if (pointer.address == nullptr) {
        fail("null_pointer", Tree::foreign(reader, term));
    }
    return pointer;
}

void Session::allocate(TermReader &reader, Term type_term, Term values, TermWriter &writer) {
    std::string spelling;
    if (!read_text(reader, type_term, spelling)) {
        fail("unknown_type", Tree::foreign(reader, type_term));
    }
    const Type &element = type_named(spelling);
    std::string_view bytes;
    ListCursor cursor;
    const bool binary = reader.read_binary(values, bytes);
    if (element.size == 0 || (!binary && !reader.read_list(values, cursor))) {
        fail("value", Tree::atom(spelling),
             Tree::tuple(
                 {Tree::atom("bad_type"), Tree::atom(spelling), Tree::foreign(reader, values)}));
    }
    const std::size_t size = binary ? bytes.size() : cursor.left * element.size;
    const std::uint64_t reference = pointers_.allocate(size, element);
    unsigned char *place = pointers_.find(reference)->address;
    if (binary) {
        std::memcpy(place, bytes.data(), bytes.size());
    }
    try {
        for (; cursor.left > 0; place += element.size) {
            value_in(*this, reader, reader.next(cursor), element, place, kept_);
        }
    } catch (const ValueError &error) {
        pointers_.free(reference);
        fail("value", Tree::atom(spelling), error.detail());
    } catch (...) {
        pointers_.free(reference);
        throw;
    }
    write_pointer(*this, writer, pointers_.find(reference)->address, element);
}

void Session::free(TermReader &reader, Term term) {
    const Pointer pointer = checked_pointer(reader, term);
    if (!pointers_.free(pointers_.reference(pointer.address, *pointer.pointee))) {
        fail("bad_pointer", Tree::foreign(reader, term)); // not one of ours
    }
}

namespace {

void check_room(const Pointer &pointer, std::uint64_t count, std::size_t unit, TermReader &reader,
                Term term) {
    if (unit == 0) {
        fail("bad_pointer", Tree::foreign(reader, term));
    }
    const bool too_long = pointer.bytes > 0 && count > pointer.bytes / unit;
    if (too_long || count > UINT32_MAX) {
        fail("out_of_bounds", Tree::foreign(reader, term),
             Tree::integer(static_cast<std::int64_t>(pointer.bytes)));
    }
}

} // namespace

void Session::read(TermReader &reader, Term term, std::uint64_t count, TermWriter &writer) {
    const Pointer pointer = checked_pointer(reader, term);
    const Type &element =
        pointer.pointee->kind == Kind::Void ? type_named("unsigned char") : *pointer.pointee;
    check_room(pointer, count, element.size, reader, term);
    writer.begin_list(static_cast<unsigned>(count));
    for (std::uint64_t i = 0; i < count; ++i) {
        value_out(*this, writer, element, pointer.address + i * element.size);
    }
    writer.end();
}

void Session::read_bytes(TermReader &reader, Term term, std::uint64_t count, TermWriter &writer) {
    const Pointer pointer = checked_pointer(reader, term);
    check_room(pointer, count, 1, reader, term);
    writer.write_binary({reinterpret_cast<const char *>(pointer.address), count});
}

void Session::cstring(TermReader &reader, Term term, TermWriter &writer) {
    const Pointer pointer = checked_pointer(reader, term);
    const char *text = reinterpret_cast<const char *>(pointer.address);
    const std::size_t length = pointer.bytes > 0 ? strnlen(text, pointer.bytes) : std::strlen(text);
    writer.write_binary({text, length});
}

} // namespace cb
