// C types as the core uses them: resolved from debug information when first needed, or built in.
#pragma once

#include "term.hpp"

#include <elfutils/libdw.h>

#include <cstdint>
#include <string>
#include <vector>

namespace cb {

enum class Kind : std::uint8_t {
    Void,
    Bool,
    Signed,
    Unsigned,
    Float, // float, double, long double, told apart by size
    Enum,
    Pointer, // references too
    Struct,
    Union,
    Array,
    Function,
    Unsupported // by value; `Type::why` says what it is
};

class TypeTable;
struct Type;

struct Member {
    Name name;
    const Type *type = nullptr;
    std::uint64_t bit_offset = 0; // from the start of the struct, bit 0 is the lowest bit of byte 0
    std::uint32_t bit_size = 0;   // 0: not a bit-field
};

struct Enumerator {
    Name name;
    std::int64_t value = 0;
};

struct Parameter {
    Name name;
    const Type *type = nullptr;
};

struct Type {
    Kind kind = Kind::Void;
    bool is_signed = false;           // of an enum
    bool is_character = false;        // char types: arrays of them take strings
    bool passed_by_reference = false; // a C++ object with a copy constructor or destructor
    std::uint64_t size = 0;
    Name spelling; // as in C
    std::uint64_t count = 0;
    std::vector<Member> members; // those of anonymous members and of base classes are among them
    std::vector<Enumerator> enumerators;
    const char *why = nullptr;

    // Pointer: what is pointed to; Array: the element. Resolved on first use, since types may be
    // circular.
    const Type &target() const {
        return known_target != nullptr ? *known_target : resolve_target();
    }
    const Type &resolve_target() const;
    mutable const Type *known_target = nullptr;
    Dwarf_Die target_die{};
    TypeTable *table = nullptr;
    // Function: the DIE its prototype is read from (DW_TAG_subroutine_type).
    Dwarf_Die prototype_die{};

    bool is_scalar() const {
        return kind >= Kind::Bool && kind <= Kind::Pointer;
    }
};

} // namespace cb
