// Reading attributes of debug information entries (DIEs).
#pragma once

#include <elfutils/libdw.h>

#include <cstdint>
#include <optional>
#include <string>

namespace cb {

// An attribute of the DIE, or of the declaration or abstract instance that it completes.
std::optional<Dwarf_Attribute> find_attribute(Dwarf_Die &die, unsigned name);
bool has_flag(Dwarf_Die &die, unsigned name);
// Whether the DIE itself is a declaration (not what it completes).
bool is_declaration(Dwarf_Die &die);
std::optional<std::uint64_t> unsigned_attribute(Dwarf_Die &die, unsigned name);
std::optional<std::int64_t> signed_attribute(Dwarf_Die &die, unsigned name);
// A constant whose form says by itself whether it is signed; forms of a fixed size do not,
// `is_signed` decides.
std::optional<std::int64_t> constant_attribute(Dwarf_Die &die, unsigned name, bool is_signed);
// Number of elements of a DW_TAG_subrange_type; 0 for a flexible array.
std::uint64_t subrange_count(Dwarf_Die &die);
std::optional<Dwarf_Die> referenced_die(Dwarf_Die &die, unsigned name);
// The DIE's own text attribute or the integrated one; nullptr if none.
const char *text_attribute(Dwarf_Die &die, unsigned name);

// Whether the DIE's compilation unit is C++.
bool in_cxx_unit(Dwarf_Die &die);

// Calls visit(Dwarf_Die &) for each child.
template <typename Visit> void each_child(Dwarf_Die &parent, Visit visit) {
    Dwarf_Die child;
    if (dwarf_child(&parent, &child) != 0) {
        return;
    }
    do {
        visit(child);
    } while (dwarf_siblingof(&child, &child) == 0);
}

// "const struct point *" and the like.
std::string type_spelling(std::optional<Dwarf_Die> die);

} // namespace cb
