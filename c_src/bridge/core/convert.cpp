#include "convert.hpp"

#include "convert_scalar.hpp"
#include "names.hpp"
#include "suggest.hpp"

#include <cstring>

namespace cb {

namespace {

constexpr unsigned kPointerParts = 3;

Tree pointer_text(TermReader &reader, Term term) {
    return Tree::foreign(reader, term);
}

// The low `size` bytes of an integer. Sizes are told apart so that each is one store.
void store_integer(void *place, std::uint64_t value, std::size_t size) {
    switch (size) {
    case 1:
        std::memcpy(place, &value, 1);
        break;
    case 2:
        std::memcpy(place, &value, 2);
        break;
    case 4:
        std::memcpy(place, &value, 4);
        break;
    default:
        std::memcpy(place, &value, 8);
    }
}

std::uint64_t load_integer(const void *place, std::size_t size) {
    std::uint64_t value = 0;
    switch (size) {
    case 1:
        std::memcpy(&value, place, 1);
        break;
    case 2:
        std::memcpy(&value, place, 2);
        break;
    case 4:
        std::memcpy(&value, place, 4);
        break;
    default:
        std::memcpy(&value, place, 8);
    }
    return value;
}

} // namespace

bool looks_like_pointer(TermReader &reader, Term term) {
    Term parts[kPointerParts];
    unsigned count = 0;
    return reader.is_atom(term, names::null) ||
           (reader.read_tuple(term, parts, kPointerParts, count) && count == kPointerParts &&
            reader.is_atom(parts[0], names::ptr));
}

Pointer read_pointer(ConversionContext &context, TermReader &reader, Term term) {
    if (reader.is_atom(term, names::null)) {
        return {};
    }
    Term parts[kPointerParts];
    unsigned count = 0;
    std::uint64_t reference = 0;
    if (!reader.read_tuple(term, parts, kPointerParts, count) || count != kPointerParts ||
        !reader.is_atom(parts[0], names::ptr) || !reader.read_unsigned(parts[2], reference)) {
        fail("bad_pointer", pointer_text(reader, term));
    }
    const PointerTable::Entry *entry = context.pointers().find(reference);
    if (entry == nullptr) {
        fail("stale_pointer", pointer_text(reader, term));
    }
    Pointer pointer{entry->address, entry->pointee, entry->bytes};
    if (reader.is_atom(parts[1], entry->pointee->spelling)) {
        return pointer;
    }
    std::string spelling;
    if (!read_text(reader, parts[1], spelling)) {
        fail("bad_pointer", pointer_text(reader, term));
    }
    pointer.pointee = &context.type_named(spelling);
    return pointer;
}

void write_pointer(ConversionContext &context, TermWriter &writer, void *address,
                   const Type &pointee) {
    if (address == nullptr) {
        return writer.write_name(names::null);
    }
    const std::uint64_t reference = context.pointers().reference(address, pointee);
    writer.begin_tuple(kPointerParts);
    writer.write_name(names::ptr);
    writer.write_name(pointee.spelling);
    writer.write_unsigned(reference);
    writer.end();
}

namespace {

// Elements of a list or the bytes of a binary into an array of `room` elements.
void list_in(ConversionContext &context, TermReader &reader, ListCursor cursor, const Type &element,
             unsigned char *place, Arena &arena) {
    while (cursor.left > 0) {
        value_in(context, reader, reader.next(cursor), element, place, arena);
        place += element.size;
    }
}

// Not inlined, here and below: the short way through value_in() is that of numbers.
[[gnu::noinline]] void array_in(ConversionContext &context, TermReader &reader, Term term,
                                const Type &type, unsigned char *place, Arena &arena) {
    const Type &element = type.target();
    std::string_view bytes;
    ListCursor cursor;
    if (reader.read_binary(term, bytes)) {
        if (bytes.size() > type.size || element.size != 1) {
            bad_value(element.size != 1 ? "bad_type" : "out_of_range", type, reader, term);
        }
        std::memset(place, 0, type.size);
        std::memcpy(place, bytes.data(), bytes.size());
    } else if (reader.read_list(term, cursor)) {
        if (cursor.left > type.count) {
            bad_value("out_of_range", type, reader, term);
        }
        std::memset(place, 0, type.size);
        list_in(context, reader, cursor, element, place, arena);
    } else {
        bad_value("bad_type", type, reader, term);
    }
}

// The size of what an argument buffer holds; void counts as bytes.
std::size_t buffer_unit(const Type &pointee, const Type &pointer, TermReader &reader, Term term) {
    if (pointee.kind == Kind::Void) {
        return 1;
    }
    if (pointee.size == 0 || pointee.kind == Kind::Function) {
        bad_value("bad_type", pointer, reader, term);
    }
    return pointee.size;
}

void *list_buffer(ConversionContext &context, TermReader &reader, Term term, ListCursor cursor,
                  const Type &type, Arena &arena) {
    const Type &pointee = type.target();
    const bool bytes = pointee.kind == Kind::Void;
    const std::size_t unit = buffer_unit(pointee, type, reader, term);
    // Strings get their NUL, lists of strings their NULL.
    const bool terminated = pointee.is_character || pointee.kind == Kind::Pointer;
    auto *buffer = static_cast<unsigned char *>(arena.take_raw((cursor.left + terminated) * unit));
    if (terminated) {
        std::memset(buffer + cursor.left * unit, 0, unit);
    }
    const Type &element = bytes ? context.type_named("unsigned char") : pointee;
    list_in(context, reader, cursor, element, buffer, arena);
    return buffer;
}

[[gnu::noinline]] void *pointer_value(ConversionContext &context, TermReader &reader, Term term,
                                      const Type &type, Arena &arena) {
    std::string_view text;
    ListCursor cursor;
    switch (reader.kind(term)) {
    case TermKind::Binary: {
        if (!reader.read_binary(term, text)) {
            bad_value("bad_type", type, reader, term);
        }
        buffer_unit(type.target(), type, reader, term);
        auto *buffer = static_cast<char *>(arena.take_raw(text.size() + 1));
        std::memcpy(buffer, text.data(), text.size());
        buffer[text.size()] = '\0';
        return buffer;
    }
    case TermKind::List:
        if (!reader.read_list(term, cursor)) {
            bad_value("bad_type", type, reader, term);
        }
        return list_buffer(context, reader, term, cursor, type, arena);
    case TermKind::Map: {
        const Type &pointee = type.target();
        if (pointee.kind != Kind::Struct && pointee.kind != Kind::Union) {
            bad_value("bad_type", type, reader, term);
        }
        void *buffer = arena.take(pointee.size);
        value_in(context, reader, term, pointee, buffer, arena);
        return buffer;
    }
    case TermKind::Atom:
        if (reader.is_atom(term, names::null)) {
            return nullptr;
        }
        if (type.target().kind == Kind::Function && reader.read_atom(term, text)) {
            return context.function_address(std::string(text));
        }
        bad_value("bad_type", type, reader, term);
    case TermKind::Tuple:
        if (looks_like_pointer(reader, term)) {
            return read_pointer(context, reader, term).address;
        }
        [[fallthrough]];
    default:
        bad_value("bad_type", type, reader, term);
    }
}

const Member *find_member(TermReader &reader, Term key, const Type &type) {
    for (const Member &member : type.members) {
        if (reader.is_atom(key, member.name)) {
            return &member;
        }
    }
    std::string text;
    if (reader.kind(key) != TermKind::Atom && read_text(reader, key, text)) {
        for (const Member &member : type.members) {
            if (member.name.text() == text) {
                return &member;
            }
        }
    }
    return nullptr;
}

[[noreturn]] void unknown_member(TermReader &reader, Term key, const Type &type) {
    std::string text;
    read_text(reader, key, text);
    Suggestions close(text);
    for (const Member &member : type.members) {
        close.offer(member.name.text());
    }
    throw ValueError(Tree::tuple({Tree::atom("unknown_member"), Tree::atom(type.spelling.text()),
                                  Tree::foreign(reader, key), close.tree()}));
}

[[gnu::noinline]] void aggregate_in(ConversionContext &context, TermReader &reader, Term term,
                                    const Type &type, unsigned char *place, Arena &arena) {
    MapEntries entries;
    if (!reader.read_map(term, entries)) {
        bad_value("bad_type", type, reader, term);
    }
    std::memset(place, 0, type.size);
    for (const auto &[key, value] : entries) {
        const Member *member = find_member(reader, key, type);
        if (member == nullptr) {
            unknown_member(reader, key, type);
        }
        member_in(context, reader, value, *member, place, arena);
    }
}

} // namespace

void value_in(ConversionContext &context, TermReader &reader, Term term, const Type &type,
              void *place, Arena &arena) {
    switch (type.kind) {
    case Kind::Bool:
    case Kind::Signed:
    case Kind::Unsigned:
    case Kind::Enum: {
        const auto bits = static_cast<unsigned>(8 * type.size);
        return store_integer(place, integer_in(reader, term, type, bits), type.size);
    }
    case Kind::Float:
        return float_in(reader, term, type, place);
    case Kind::Pointer: {
        void *address = pointer_value(context, reader, term, type, arena);
        std::memcpy(place, &address, sizeof address);
        return;
    }
    case Kind::Array:
        return array_in(context, reader, term, type, static_cast<unsigned char *>(place), arena);
    case Kind::Struct:
    case Kind::Union:
        return aggregate_in(context, reader, term, type, static_cast<unsigned char *>(place),
                            arena);
    case Kind::Void:
    case Kind::Function:
    case Kind::Unsupported:
        bad_value("bad_type", type, reader, term);
    }
}

void member_in(ConversionContext &context, TermReader &reader, Term term, const Member &member,
               unsigned char *base, Arena &arena) {
    if (member.bit_size == 0) {
        return value_in(context, reader, term, *member.type, base + member.bit_offset / 8, arena);
    }
    const std::uint64_t value = integer_in(reader, term, *member.type, member.bit_size);
    store_bits(base, member.bit_offset, member.bit_size, value);
}

void value_out(ConversionContext &context, TermWriter &writer, const Type &type,
               const void *place) {
    const auto *bytes = static_cast<const unsigned char *>(place);
    switch (type.kind) {
    case Kind::Bool:
    case Kind::Signed:
    case Kind::Unsigned:
    case Kind::Enum: {
        return integer_out(writer, type, load_integer(place, type.size),
                           static_cast<unsigned>(8 * type.size));
    }
    case Kind::Float:
        return float_out(writer, type, place);
    case Kind::Pointer: {
        void *address = nullptr;
        std::memcpy(&address, place, sizeof address);
        return address == nullptr ? writer.write_name(names::null)
                                  : write_pointer(context, writer, address, type.target());
    }
    case Kind::Array:
        writer.begin_list(static_cast<unsigned>(type.count));
        for (std::uint64_t i = 0; i < type.count; ++i) {
            value_out(context, writer, type.target(), bytes + i * type.target().size);
        }
        return writer.end();
    case Kind::Struct:
    case Kind::Union:
        writer.begin_map(static_cast<unsigned>(type.members.size()));
        for (const Member &member : type.members) {
            writer.write_name(member.name);
            member_out(context, writer, member, bytes);
        }
        return writer.end();
    case Kind::Void:
        return writer.write_name(names::ok);
    case Kind::Function:
    case Kind::Unsupported:
        return writer.write_atom("unsupported");
    }
}

void member_out(ConversionContext &context, TermWriter &writer, const Member &member,
                const unsigned char *base) {
    if (member.bit_size == 0) {
        return value_out(context, writer, *member.type, base + member.bit_offset / 8);
    }
    const std::uint64_t value = load_bits(base, member.bit_offset, member.bit_size);
    integer_out(writer, *member.type, value, member.bit_size);
}

} // namespace cb
