#include "type_table.hpp"

#include "dwarf_die.hpp"

#include <dwarf.h>

#include <algorithm>
#include <cstring>

namespace cb {

const Type &Type::resolve_target() const {
    return *(known_target = &table->of(target_die));
}

TypeTable::TypeTable(FindDefinition find_definition)
    : find_definition_(std::move(find_definition)) {
    Type nothing;
    nothing.spelling = "void";
    void_ = &add(nothing);
    add_built_ins();
}

Type &TypeTable::add(Type type) {
    type.table = this;
    made_.push_back(std::make_unique<Type>(std::move(type)));
    return *made_.back();
}

void TypeTable::add_built_ins() {
    const auto number = [this](Kind kind, unsigned size,
                               std::initializer_list<const char *> names) {
        for (const char *name : names) {
            Type type;
            type.kind = kind;
            type.size = size;
            type.spelling = name;
            type.is_character = size == 1 && kind != Kind::Bool;
            built_ins_[name] = &add(type);
        }
    };
    number(Kind::Bool, 1, {"bool", "_Bool"});
    number(Kind::Signed, 1, {"char", "signed char", "int8_t"});
    number(Kind::Signed, 2, {"short", "short int", "signed short", "int16_t"});
    number(Kind::Signed, 4, {"int", "signed int", "signed", "int32_t"});
    number(Kind::Signed, 8,
           {"long", "long int", "signed long", "long long", "long long int", "signed long long",
            "int64_t", "ssize_t", "ptrdiff_t", "intptr_t"});
    number(Kind::Unsigned, 1, {"unsigned char", "uint8_t"});
    number(Kind::Unsigned, 2,
           {"unsigned short", "short unsigned int", "unsigned short int", "uint16_t"});
    number(Kind::Unsigned, 4, {"unsigned int", "unsigned", "uint32_t"});
    number(Kind::Unsigned, 8,
           {"unsigned long", "long unsigned int", "unsigned long int", "unsigned long long",
            "long long unsigned int", "unsigned long long int", "uint64_t", "size_t", "uintptr_t"});
    number(Kind::Float, 4, {"float"});
    number(Kind::Float, 8, {"double"});
    number(Kind::Float, sizeof(long double), {"long double"});
    built_ins_["void"] = void_;
}

const Type *TypeTable::built_in(const std::string &name) const {
    const auto found = built_ins_.find(name);
    return found == built_ins_.end() ? nullptr : found->second;
}

const Type &TypeTable::pointer_to(const Type &target) {
    const Type *&known = pointers_[&target];
    if (known == nullptr) {
        Type pointer;
        pointer.kind = Kind::Pointer;
        pointer.size = sizeof(void *);
        const std::string &text = target.spelling.text();
        pointer.spelling = text + (text.back() == '*' ? "*" : " *");
        pointer.known_target = &target;
        known = &add(pointer);
    }
    return *known;
}

const Type &TypeTable::array_of(const Type &element, std::uint64_t count) {
    Type array;
    array.kind = Kind::Array;
    array.count = count;
    array.size = count * element.size;
    array.spelling = element.spelling.text() + "[" + std::to_string(count) + "]";
    array.known_target = &element;
    return add(array);
}

const Type &TypeTable::of(Dwarf_Die die) {
    const auto known = by_die_.find(die.addr);
    if (known != by_die_.end()) {
        return *known->second;
    }
    std::unique_ptr<Type> type = read(die);
    return *by_die_.emplace(die.addr, std::move(type)).first->second;
}

std::unique_ptr<Type> TypeTable::read(Dwarf_Die die) {
    auto type = std::make_unique<Type>();
    type->table = this;
    switch (dwarf_tag(&die)) {
    case DW_TAG_base_type:
        read_base(die, *type);
        break;
    case DW_TAG_pointer_type:
    case DW_TAG_reference_type:
    case DW_TAG_rvalue_reference_type: {
        type->kind = Kind::Pointer;
        type->size = sizeof(void *);
        auto target = referenced_die(die, DW_AT_type);
        type->known_target = target ? nullptr : void_;
        type->target_die = target.value_or(Dwarf_Die{});
        break;
    }
    case DW_TAG_enumeration_type:
        read_enum(die, *type);
        break;
    case DW_TAG_structure_type:
    case DW_TAG_class_type:
    case DW_TAG_union_type:
        read_aggregate(die, *type);
        break;
    case DW_TAG_array_type:
        read_array(die, *type);
        break;
    case DW_TAG_subroutine_type:
        type->kind = Kind::Function;
        type->prototype_die = die;
        break;
    case DW_TAG_typedef:
    case DW_TAG_const_type:
    case DW_TAG_volatile_type:
    case DW_TAG_restrict_type:
    case DW_TAG_atomic_type:
        read_alias(die, *type);
        break;
    case DW_TAG_unspecified_type: // decltype(nullptr)
        type->kind = Kind::Void;
        break;
    default:
        type->kind = Kind::Unsupported;
        type->why = "this kind of type is not supported";
    }
    type->spelling = type_spelling(die);
    return type;
}

void TypeTable::read_base(Dwarf_Die &die, Type &type) {
    type.size = unsigned_attribute(die, DW_AT_byte_size).value_or(0);
    switch (unsigned_attribute(die, DW_AT_encoding).value_or(0)) {
    case DW_ATE_boolean:
        type.kind = Kind::Bool;
        break;
    case DW_ATE_signed_char:
        type.is_character = true;
        [[fallthrough]];
    case DW_ATE_signed:
        type.kind = Kind::Signed;
        break;
    case DW_ATE_unsigned_char:
    case DW_ATE_UTF:
        type.is_character = type.size == 1;
        [[fallthrough]];
    case DW_ATE_unsigned:
        type.kind = Kind::Unsigned;
        break;
    case DW_ATE_float:
        type.kind = Kind::Float;
        break;
    default:
        type.kind = Kind::Unsupported;
        type.why = "complex, decimal and fixed point numbers are not supported";
    }
    const bool wide_integer = type.kind != Kind::Float && type.size > 8;
    const bool odd_float =
        type.kind == Kind::Float && type.size != sizeof(float) && type.size != sizeof(double) &&
        (type.size != sizeof(long double) || type_spelling(die) != "long double"); // not __float128
    if (type.kind != Kind::Unsupported && (wide_integer || odd_float)) {
        type.kind = Kind::Unsupported;
        type.why = "128-bit numbers are not supported";
    }
}

void TypeTable::read_enum(Dwarf_Die &die, Type &type) {
    type.kind = Kind::Enum;
    type.size = unsigned_attribute(die, DW_AT_byte_size).value_or(4);
    auto underlying = referenced_die(die, DW_AT_type);
    type.is_signed = underlying && of(*underlying).kind == Kind::Signed;
    each_child(die, [&](Dwarf_Die &child) {
        const char *name = dwarf_diename(&child);
        if (dwarf_tag(&child) == DW_TAG_enumerator && name != nullptr) {
            auto value = constant_attribute(child, DW_AT_const_value, type.is_signed);
            type.enumerators.push_back(Enumerator{name, value.value_or(0)});
        }
    });
}

namespace {

// A constructor that takes another object of the class, or the destructor, written by hand.
bool is_special_function(Dwarf_Die &function, const char *class_name) {
    const char *name = dwarf_diename(&function);
    if (name == nullptr || has_flag(function, DW_AT_artificial) ||
        find_attribute(function, DW_AT_defaulted)) {
        return false;
    }
    bool takes_another = false;
    if (std::strcmp(name, class_name) == 0) {
        const std::string own(class_name);
        each_child(function, [&](Dwarf_Die &child) {
            const std::string type = type_spelling(referenced_die(child, DW_AT_type));
            takes_another = takes_another || type == own + " &" || type == "const " + own + " &" ||
                            type == own + " &&";
        });
    }
    return name[0] == '~' || takes_another;
}

// C++ passes such objects by reference, of which not every compiler leaves a word.
bool not_trivially_copied(Dwarf_Die &die) {
    if (auto convention = unsigned_attribute(die, DW_AT_calling_convention)) {
        return *convention == DW_CC_pass_by_reference;
    }
    const char *name = text_attribute(die, DW_AT_name);
    if (name == nullptr || !in_cxx_unit(die)) {
        return false;
    }
    bool special = false;
    each_child(die, [&](Dwarf_Die &child) {
        const bool function = dwarf_tag(&child) == DW_TAG_subprogram;
        special = special || (function && (is_special_function(child, name) ||
                                           find_attribute(child, DW_AT_virtuality).has_value()));
    });
    return special;
}

} // namespace

void TypeTable::read_aggregate(Dwarf_Die &die, Type &type) {
    Dwarf_Die complete = die;
    if (is_declaration(die)) {
        const char *name = text_attribute(die, DW_AT_name);
        auto found = name == nullptr ? std::nullopt : find_definition_(name, dwarf_tag(&die));
        if (!found) {
            type.kind = Kind::Unsupported;
            type.why = "incomplete type";
            return;
        }
        complete = *found;
    }
    type.kind = dwarf_tag(&complete) == DW_TAG_union_type ? Kind::Union : Kind::Struct;
    type.size = unsigned_attribute(complete, DW_AT_byte_size).value_or(0);
    type.passed_by_reference = not_trivially_copied(complete);
    each_child(complete, [&](Dwarf_Die &child) {
        const int tag = dwarf_tag(&child);
        if (tag == DW_TAG_member || tag == DW_TAG_inheritance) {
            read_member(child, type);
        }
    });
}

namespace {

// A class may have a member of the same name as its base: the class's own is the one that C++
// means.
void put_member(Type &type, Member member) {
    const auto same = [&](const Member &known) { return known.name.text() == member.name.text(); };
    const auto known = std::find_if(type.members.begin(), type.members.end(), same);
    if (known == type.members.end()) {
        type.members.push_back(std::move(member));
    } else {
        *known = std::move(member);
    }
}

} // namespace

void TypeTable::read_member(Dwarf_Die &die, Type &type) {
    auto member_die = referenced_die(die, DW_AT_type);
    if (!member_die || has_flag(die, DW_AT_external) || has_flag(die, DW_AT_declaration) ||
        has_flag(die, DW_AT_artificial)) {
        return; // static members of classes, tables of virtual functions
    }
    Member member;
    member.type = &of(*member_die);
    type.passed_by_reference = type.passed_by_reference || member.type->passed_by_reference;
    const std::uint64_t byte_offset =
        unsigned_attribute(die, DW_AT_data_member_location).value_or(0);
    member.bit_offset = 8 * byte_offset;
    member.bit_size =
        static_cast<std::uint32_t>(unsigned_attribute(die, DW_AT_bit_size).value_or(0));
    if (auto absolute = unsigned_attribute(die, DW_AT_data_bit_offset)) {
        member.bit_offset = *absolute;
    } else if (auto from_top = signed_attribute(die, DW_AT_bit_offset)) {
        // DWARF 2 and 3 count from the most significant bit of the storage unit.
        const std::uint64_t storage =
            unsigned_attribute(die, DW_AT_byte_size).value_or(member.type->size);
        member.bit_offset =
            8 * byte_offset + 8 * storage - member.bit_size - static_cast<std::uint64_t>(*from_top);
    }
    const char *name = dwarf_diename(&die);
    const bool aggregate = member.type->kind == Kind::Struct || member.type->kind == Kind::Union;
    if ((name == nullptr || dwarf_tag(&die) == DW_TAG_inheritance) && aggregate) {
        for (Member inner : member.type->members) {
            inner.bit_offset += member.bit_offset;
            put_member(type, std::move(inner));
        }
    } else if (name != nullptr) {
        member.name = name;
        put_member(type, std::move(member));
    }
}

void TypeTable::read_array(Dwarf_Die &die, Type &type) {
    auto element = referenced_die(die, DW_AT_type);
    type.kind = Kind::Array;
    if (has_flag(die, DW_AT_GNU_vector)) {
        type.kind = Kind::Unsupported;
        type.why = "vector types are not supported";
    }
    std::vector<std::uint64_t> counts;
    each_child(die, [&](Dwarf_Die &child) {
        if (dwarf_tag(&child) == DW_TAG_subrange_type) {
            counts.push_back(subrange_count(child));
        }
    });
    if (counts.empty()) {
        counts.push_back(0);
    }
    const Type *inner = &of(element);
    for (std::size_t i = counts.size(); i > 1; --i) {
        inner = &array_of(*inner, counts[i - 1]);
    }
    type.count = counts[0];
    type.known_target = inner;
    type.size = type.count * inner->size;
}

// Typedefs and qualified types are copies of what they name, under their own spelling.
void TypeTable::read_alias(Dwarf_Die &die, Type &type) {
    auto target = referenced_die(die, DW_AT_type);
    type = of(target);
}

} // namespace cb
