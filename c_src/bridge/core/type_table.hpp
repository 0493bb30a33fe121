// From debug information to types, each resolved once.
#pragma once

#include "type.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>

namespace cb {

class TypeTable {
  public:
    // Finds the complete definition of a type that is only declared in its own unit.
    using FindDefinition =
        std::function<std::optional<Dwarf_Die>(const std::string &name, int tag)>;
    explicit TypeTable(FindDefinition find_definition);

    const Type &of(Dwarf_Die die);
    const Type &of(std::optional<Dwarf_Die> die) {
        return die ? of(*die) : void_type();
    }
    const Type &void_type() const {
        return *void_;
    }
    // int, unsigned char, uint8_t, ...; nullptr if the name is not a type that every library knows.
    const Type *built_in(const std::string &name) const;
    const Type &pointer_to(const Type &target);
    const Type &array_of(const Type &element, std::uint64_t count);

  private:
    std::unique_ptr<Type> read(Dwarf_Die die);
    void read_base(Dwarf_Die &die, Type &type);
    void read_enum(Dwarf_Die &die, Type &type);
    void read_aggregate(Dwarf_Die &die, Type &type);
    void read_member(Dwarf_Die &die, Type &type);
    void read_array(Dwarf_Die &die, Type &type);
    void read_alias(Dwarf_Die &die, Type &type);
    Type &add(Type type);
    void add_built_ins();

    FindDefinition find_definition_;
    std::unordered_map<void *, std::unique_ptr<Type>> by_die_;
    std::vector<std::unique_ptr<Type>> made_;
    std::unordered_map<std::string, const Type *> built_ins_;
    std::unordered_map<const Type *, const Type *> pointers_;
    const Type *void_;
};

} // namespace cb
