// Buffers for the library, and reading what pointers point to.
#include "session.hpp"

#include "error.hpp"
#include "safe_memory.hpp"

#include <algorithm>
#include <cstring>

namespace cb {

namespace {

// More in one piece would not fit a message.
constexpr std::uint64_t kLargestPiece = 256U << 20;

} // namespace

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
    if (cursor.left > kLargestPiece / element.size) {
        fail("no_memory");
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
    const std::uint64_t room = pointer.bytes > 0 ? pointer.bytes : kLargestPiece;
    if (count > room / unit) {
        fail("out_of_bounds", Tree::foreign(reader, term),
             Tree::integer(static_cast<std::int64_t>(room)));
    }
}

} // namespace

// The bytes behind a pointer: in place if they are a buffer of ours, else a copy.
const unsigned char *Session::bytes_behind(const Pointer &pointer, std::size_t size,
                                           TermReader &reader, Term term) {
    if (pointer.bytes > 0) {
        return pointer.address;
    }
    arena_.clear();
    auto *copy = static_cast<unsigned char *>(arena_.take_raw(size));
    if (!read_safely(copy, pointer.address, size)) {
        fail("bad_pointer", Tree::foreign(reader, term));
    }
    return copy;
}

void Session::read(TermReader &reader, Term term, std::uint64_t count, TermWriter &writer) {
    const Pointer pointer = checked_pointer(reader, term);
    const Type &element =
        pointer.pointee->kind == Kind::Void ? type_named("unsigned char") : *pointer.pointee;
    check_room(pointer, count, element.size, reader, term);
    const unsigned char *bytes = bytes_behind(pointer, count * element.size, reader, term);
    writer.begin_list(static_cast<unsigned>(count));
    for (std::uint64_t i = 0; i < count; ++i) {
        value_out(*this, writer, element, bytes + i * element.size);
    }
    writer.end();
}

void Session::read_bytes(TermReader &reader, Term term, std::uint64_t count, TermWriter &writer) {
    const Pointer pointer = checked_pointer(reader, term);
    check_room(pointer, count, 1, reader, term);
    const unsigned char *bytes = bytes_behind(pointer, count, reader, term);
    writer.write_binary({reinterpret_cast<const char *>(bytes), count});
}

void Session::cstring(TermReader &reader, Term term, TermWriter &writer) {
    constexpr std::size_t kPiece =
        256; // a divisor of the page size: what is readable is found exactly
    const Pointer pointer = checked_pointer(reader, term);
    std::string text;
    std::size_t room = pointer.bytes > 0 ? pointer.bytes : kLargestPiece;
    for (const unsigned char *at = pointer.address; room > 0;) {
        char piece[kPiece];
        const std::size_t to_border = kPiece - reinterpret_cast<std::uintptr_t>(at) % kPiece;
        const std::size_t size = std::min(room, to_border);
        if (!read_safely(piece, at, size)) {
            fail("bad_pointer", Tree::foreign(reader, term));
        }
        const std::size_t length = strnlen(piece, size);
        text.append(piece, length);
        at += size;
        room = length < size ? 0 : room - size;
    }
    writer.write_binary(text);
}

} // namespace cb
