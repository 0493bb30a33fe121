#include "function.hpp"

#include "dwarf_die.hpp"
#include "type_table.hpp"

#include <dwarf.h>

namespace cb {

Prototype read_prototype(Dwarf_Die &die, TypeTable &types) {
    Prototype prototype;
    prototype.result = &types.of(referenced_die(die, DW_AT_type));
    each_child(die, [&](Dwarf_Die &child) {
        const int tag = dwarf_tag(&child);
        if (tag == DW_TAG_formal_parameter) {
            const char *name = text_attribute(child, DW_AT_name);
            const std::string position = std::to_string(prototype.parameters.size() + 1);
            prototype.parameters.push_back(
                Parameter{name != nullptr ? Name(name) : Name("arg" + position),
                          &types.of(referenced_die(child, DW_AT_type))});
        } else if (tag == DW_TAG_unspecified_parameters) {
            prototype.variadic = true;
        }
    });
    const bool old_style = !has_flag(die, DW_AT_prototyped) && !in_cxx_unit(die);
    prototype.any_arguments = old_style && prototype.parameters.empty();
    prototype.promotes_floats =
        old_style && !prototype.parameters.empty() && dwarf_tag(&die) == DW_TAG_subprogram;
    return prototype;
}

std::string Prototype::text(const std::string &name) const {
    std::string inside;
    for (const Parameter &parameter : parameters) {
        const std::string &type = parameter.type->spelling.text();
        inside += (inside.empty() ? "" : ", ") + type + (type.back() == '*' ? "" : " ") +
                  parameter.name.text();
    }
    if (variadic && !any_arguments) {
        inside += inside.empty() ? "..." : ", ...";
    } else if (inside.empty() && !any_arguments) {
        inside = "void";
    }
    const std::string &type = result->spelling.text();
    return type + (type.back() == '*' ? "" : " ") + name + "(" + inside + ")";
}

} // namespace cb
