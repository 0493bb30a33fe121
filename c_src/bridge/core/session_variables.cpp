// Variables of a session: finding them, walking paths into them, reading and writing.
#include "session.hpp"

#include "dwarf_die.hpp"
#include "error.hpp"
#include "safe_memory.hpp"
#include "suggest.hpp"

#include <dwarf.h>

#include <cstring>

namespace cb {

const Session::KnownVariable *Session::find_variable(const std::string &name) {
    const auto known = known_variables_.find(name);
    if (known != known_variables_.end()) {
        return &known->second;
    }
    std::optional<KnownVariable> found = find_variable_in_files(name);
    return found ? &known_variables_.emplace(name, std::move(*found)).first->second : nullptr;
}

std::optional<Session::KnownVariable> Session::find_variable_in_files(const std::string &name) {
    const char *refusal = nullptr;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        const DebugInfo *info = parts_[part].info.get();
        for (Dwarf_Die &die : info != nullptr ? info->variables(name) : std::vector<Dwarf_Die>{}) {
            const Location location = DebugInfo::location(die);
            const Type &type = types_.of(referenced_die(die, DW_AT_type));
            if (location.kind == Location::Kind::Address) {
                return KnownVariable{FilePlace{part, location.address, ""}, &type};
            }
            // The dynamic linker knows where this thread's copy of an exported variable is.
            if (location.kind == Location::Kind::ThreadLocal && has_flag(die, DW_AT_external) &&
                library_->symbol(name.c_str()) != nullptr) {
                return KnownVariable{FilePlace{part, 0, name}, &type};
            }
            refusal =
                location.kind == Location::Kind::ThreadLocal ? "thread_local" : "optimised_out";
        }
    }
    for (Dwarf_Die &die : signatures_ != nullptr
                              ? signatures_->variables(std::string(kSignaturePrefix) + name)
                              : std::vector<Dwarf_Die>{}) {
        const Type &pointer = types_.of(referenced_die(die, DW_AT_type));
        if (pointer.kind == Kind::Pointer && pointer.target().kind != Kind::Function &&
            library_->symbol(name.c_str()) != nullptr) {
            return KnownVariable{FilePlace{0, 0, name}, &pointer.target()};
        }
    }
    if (refusal != nullptr) {
        fail("not_accessible", Tree::atom(name), Tree::atom(refusal));
    }
    return std::nullopt;
}

void Session::unknown_variable(const std::string &name) const {
    Suggestions close(name);
    for (const Part &part : parts_) {
        if (part.info != nullptr) {
            part.info->each_variable(
                [&](std::string_view candidate, Dwarf_Die &) { close.offer(candidate); });
        }
    }
    fail("unknown_variable", Tree::atom(name), close.tree());
}

// Follows a pointer in memory before a step into what it points to.
void Session::follow(TermReader &reader, Term path, Place &place) {
    unsigned char *target = nullptr;
    if (!place.behind_pointer) {
        std::memcpy(&target, place.address, sizeof target);
    } else if (!read_safely(&target, place.address, sizeof target)) {
        fail("bad_pointer", Tree::foreign(reader, path));
    }
    if (target == nullptr) {
        fail("null_pointer", Tree::foreign(reader, path));
    }
    place.address = target;
    place.behind_pointer = true;
}

void Session::step_member(TermReader &reader, Term path, Term step, const std::string &name,
                          Place &place) {
    const Type *type = place.member.type;
    if (type->kind == Kind::Pointer) {
        follow(reader, path, place);
        type = &type->target();
    }
    Suggestions close(name);
    for (const Member &member : type->members) {
        if (member.name.text() == name) {
            const Member found = member; // `type` may be part of what is overwritten now
            place.member = found;
            if (found.bit_size == 0) {
                place.address += found.bit_offset / 8;
                place.member.bit_offset = 0;
            }
            return;
        }
        close.offer(member.name.text());
    }
    fail("unknown_member", Tree::foreign(reader, path), Tree::foreign(reader, step), close.tree());
}

void Session::step_index(TermReader &reader, Term path, std::int64_t index, Place &place) {
    const Type &type = *place.member.type;
    const bool array = type.kind == Kind::Array;
    const Type *element = array || type.kind == Kind::Pointer ? &type.target() : nullptr;
    // An array without a size, as at the end of a struct, is as long as its owner made it.
    const bool outside =
        array && type.count > 0 && (index < 0 || static_cast<std::uint64_t>(index) >= type.count);
    if (element == nullptr || element->size == 0 || outside || place.member.bit_size != 0) {
        fail("bad_index", Tree::foreign(reader, path), Tree::integer(index),
             Tree::integer(array ? static_cast<std::int64_t>(type.count) : 0));
    }
    if (!array) {
        follow(reader, path, place);
    }
    place.address += index * static_cast<std::int64_t>(element->size);
    place.member = Member{Name(), element, 0, 0};
}

Session::Place Session::walk(TermReader &reader, Term path) {
    ListCursor cursor;
    std::string name;
    if (!reader.read_list(path, cursor) || cursor.left == 0) {
        fail("bad_request", Tree::foreign(reader, path));
    }
    Place place;
    const Term start = reader.next(cursor);
    if (looks_like_pointer(reader, start)) {
        const Pointer pointer = read_pointer(*this, reader, start);
        if (pointer.address == nullptr) {
            fail("null_pointer", Tree::foreign(reader, path));
        }
        // As if it were a variable of pointer type: the address itself must lie in memory.
        path_pointer_ = pointer.address;
        place.address = reinterpret_cast<unsigned char *>(&path_pointer_);
        place.member.type = &types_.pointer_to(*pointer.pointee);
    } else if (read_text(reader, start, name)) {
        const KnownVariable *variable = find_variable(name);
        if (variable == nullptr) {
            unknown_variable(name);
        }
        place.address = address_in_memory(variable->place);
        place.member.type = variable->type;
    } else {
        fail("bad_request", Tree::foreign(reader, path));
    }
    while (cursor.left > 0) {
        const Term step = reader.next(cursor);
        std::int64_t index = 0;
        if (reader.read_signed(step, index)) {
            step_index(reader, path, index, place);
        } else if (read_text(reader, step, name)) {
            step_member(reader, path, step, name, place);
        } else {
            fail("bad_request", Tree::foreign(reader, path));
        }
    }
    return place;
}

void Session::get(TermReader &reader, Term path, TermWriter &writer) {
    const Place place = walk(reader, path);
    const unsigned char *bytes = place.address;
    if (place.behind_pointer) {
        arena_.clear();
        auto *copy = static_cast<unsigned char *>(arena_.take_raw(place.extent()));
        if (!read_safely(copy, place.address, place.extent())) {
            fail("bad_pointer", Tree::foreign(reader, path));
        }
        bytes = copy;
    }
    member_out(*this, writer, place.member, bytes);
}

// Converted apart and copied when all of it is right, so that an error leaves the variable as it
// was.
void Session::set(TermReader &reader, Term path, Term value) {
    const Place place = walk(reader, path);
    const std::size_t size = place.extent();
    if (is_read_only(place.address)) {
        fail("read_only", Tree::foreign(reader, path));
    }
    arena_.clear();
    auto *copy = static_cast<unsigned char *>(arena_.take(size));
    // A bit-field shares its bytes with others.
    if (place.member.bit_size != 0 && !read_safely(copy, place.address, size)) {
        fail("bad_pointer", Tree::foreign(reader, path));
    }
    try {
        member_in(*this, reader, value, place.member, copy, kept_);
    } catch (const ValueError &error) {
        fail("value", Tree::foreign(reader, path), error.detail());
    }
    if (!place.behind_pointer) {
        std::memcpy(place.address, copy, size);
    } else if (!write_safely(place.address, copy, size)) {
        fail("bad_pointer", Tree::foreign(reader, path));
    }
}

void Session::address_of(TermReader &reader, Term path, TermWriter &writer) {
    ListCursor cursor;
    std::string name;
    if (reader.read_list(path, cursor) && cursor.left == 1) {
        ListCursor look = cursor;
        const Term start = reader.next(look);
        if (!looks_like_pointer(reader, start) && read_text(reader, start, name) &&
            find_variable(name) == nullptr) {
            return write_pointer(*this, writer, function(name).address, types_.void_type());
        }
    }
    const Place place = walk(reader, path);
    if (place.member.bit_size != 0) {
        fail("bad_request", Tree::foreign(reader, path));
    }
    write_pointer(*this, writer, place.address, *place.member.type);
}

} // namespace cb
