#include "dwarf_die.hpp"

#include <dwarf.h>

namespace cb {

std::optional<Dwarf_Attribute> find_attribute(Dwarf_Die &die, unsigned name) {
    Dwarf_Attribute attribute;
    if (dwarf_attr_integrate(&die, name, &attribute) == nullptr) {
        return std::nullopt;
    }
    return attribute;
}

bool has_flag(Dwarf_Die &die, unsigned name) {
    auto attribute = find_attribute(die, name);
    bool set = false;
    return attribute && dwarf_formflag(&*attribute, &set) == 0 && set;
}

bool is_declaration(Dwarf_Die &die) {
    Dwarf_Attribute attribute;
    return dwarf_attr(&die, DW_AT_declaration, &attribute) != nullptr;
}

std::optional<std::uint64_t> unsigned_attribute(Dwarf_Die &die, unsigned name) {
    auto attribute = find_attribute(die, name);
    Dwarf_Word value = 0;
    if (!attribute || dwarf_formudata(&*attribute, &value) != 0) {
        return std::nullopt;
    }
    return value;
}

std::optional<std::int64_t> signed_attribute(Dwarf_Die &die, unsigned name) {
    auto attribute = find_attribute(die, name);
    Dwarf_Sword value = 0;
    if (!attribute || dwarf_formsdata(&*attribute, &value) != 0) {
        return std::nullopt;
    }
    return value;
}

std::optional<std::int64_t> constant_attribute(Dwarf_Die &die, unsigned name, bool is_signed) {
    auto attribute = find_attribute(die, name);
    if (!attribute) {
        return std::nullopt;
    }
    const unsigned form = dwarf_whatform(&*attribute);
    if (form == DW_FORM_sdata || form == DW_FORM_implicit_const ||
        (is_signed && form != DW_FORM_udata)) {
        return signed_attribute(die, name);
    }
    auto value = unsigned_attribute(die, name);
    return value ? std::optional<std::int64_t>(static_cast<std::int64_t>(*value)) : std::nullopt;
}

std::uint64_t subrange_count(Dwarf_Die &die) {
    auto count = constant_attribute(die, DW_AT_count, false);
    auto upper = constant_attribute(die, DW_AT_upper_bound, false);
    const std::int64_t known = count ? *count : upper ? *upper + 1 : 0;
    return known > 0 ? static_cast<std::uint64_t>(known) : 0;
}

std::optional<Dwarf_Die> referenced_die(Dwarf_Die &die, unsigned name) {
    auto attribute = find_attribute(die, name);
    Dwarf_Die target;
    if (!attribute || dwarf_formref_die(&*attribute, &target) == nullptr) {
        return std::nullopt;
    }
    // A type in a unit of its own is represented by a declaration that carries its signature.
    Dwarf_Attribute signature;
    Dwarf_Die type;
    if (dwarf_attr(&target, DW_AT_signature, &signature) != nullptr &&
        dwarf_formref_die(&signature, &type) != nullptr) {
        return type;
    }
    return target;
}

const char *text_attribute(Dwarf_Die &die, unsigned name) {
    auto attribute = find_attribute(die, name);
    return attribute ? dwarf_formstring(&*attribute) : nullptr;
}

bool in_cxx_unit(Dwarf_Die &die) {
    Dwarf_Die unit;
    if (dwarf_diecu(&die, &unit, nullptr, nullptr) == nullptr) {
        return false;
    }
    switch (dwarf_srclang(&unit)) {
    case DW_LANG_C_plus_plus:
    case DW_LANG_C_plus_plus_03:
    case DW_LANG_C_plus_plus_11:
    case DW_LANG_C_plus_plus_14:
    case 0x2b: // DW_LANG_C_plus_plus_17, not in every dwarf.h
    case 0x2c: // DW_LANG_C_plus_plus_20
        return true;
    default:
        return false;
    }
}

namespace {

constexpr int kDeepest = 64;

std::string spelling(std::optional<Dwarf_Die> die, int depth);

std::string target_spelling(Dwarf_Die &die, int depth) {
    return spelling(referenced_die(die, DW_AT_type), depth + 1);
}

std::string tagged(const char *tag, Dwarf_Die &die) {
    const char *name = text_attribute(die, DW_AT_name);
    return std::string(tag) + " " + (name != nullptr ? name : "(anonymous)");
}

std::string aggregate(const char *tag, Dwarf_Die &die) {
    const char *name = text_attribute(die, DW_AT_name);
    return name != nullptr && in_cxx_unit(die) ? name : tagged(tag, die);
}

std::string function_spelling(Dwarf_Die &die, const char *middle, int depth) {
    std::string parameters;
    each_child(die, [&](Dwarf_Die &child) {
        const int tag = dwarf_tag(&child);
        if (tag != DW_TAG_formal_parameter && tag != DW_TAG_unspecified_parameters) {
            return;
        }
        parameters += parameters.empty() ? "" : ", ";
        parameters += tag == DW_TAG_formal_parameter ? target_spelling(child, depth) : "...";
    });
    return target_spelling(die, depth) + " (" + middle + ")(" +
           (parameters.empty() ? "void" : parameters) + ")";
}

std::string dimensions(Dwarf_Die &array) {
    std::string text;
    each_child(array, [&](Dwarf_Die &child) {
        if (dwarf_tag(&child) == DW_TAG_subrange_type) {
            const std::uint64_t count = subrange_count(child);
            text += "[" + (count > 0 ? std::to_string(count) : std::string()) + "]";
        }
    });
    return text;
}

std::string pointer_spelling(Dwarf_Die &die, int depth) {
    auto target = referenced_die(die, DW_AT_type);
    if (target && dwarf_tag(&*target) == DW_TAG_subroutine_type) {
        return function_spelling(*target, "*", depth + 1);
    }
    const std::string pointed = spelling(target, depth + 1);
    return pointed + (pointed.back() == '*' ? "*" : " *");
}

std::string spelling(std::optional<Dwarf_Die> die, int depth) {
    if (!die || depth > kDeepest) {
        return depth > kDeepest ? "..." : "void";
    }
    switch (dwarf_tag(&*die)) {
    case DW_TAG_pointer_type:
        return pointer_spelling(*die, depth);
    case DW_TAG_reference_type:
        return target_spelling(*die, depth) + " &";
    case DW_TAG_rvalue_reference_type:
        return target_spelling(*die, depth) + " &&";
    case DW_TAG_const_type: {
        auto target = referenced_die(*die, DW_AT_type);
        const bool behind = target && dwarf_tag(&*target) == DW_TAG_pointer_type;
        const std::string inner = spelling(target, depth + 1);
        if (target && dwarf_tag(&*target) == DW_TAG_array_type) {
            return inner; // its elements are const already
        }
        return behind ? inner + "const" : "const " + inner;
    }
    case DW_TAG_volatile_type:
        return "volatile " + target_spelling(*die, depth);
    case DW_TAG_restrict_type:
    case DW_TAG_atomic_type:
        return target_spelling(*die, depth);
    case DW_TAG_structure_type:
    case DW_TAG_class_type:
        return aggregate("struct", *die);
    case DW_TAG_union_type:
        return aggregate("union", *die);
    case DW_TAG_enumeration_type:
        return aggregate("enum", *die);
    case DW_TAG_array_type:
        return target_spelling(*die, depth) + dimensions(*die);
    case DW_TAG_subroutine_type:
        return function_spelling(*die, "", depth);
    default: {
        const char *name = text_attribute(*die, DW_AT_name);
        return name != nullptr ? name : "(unnamed type)";
    }
    }
}

} // namespace

std::string type_spelling(std::optional<Dwarf_Die> die) {
    return spelling(die, 0);
}

} // namespace cb
