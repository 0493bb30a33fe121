#include "debug_info.hpp"

#include "debug_files.hpp"
#include "dwarf_die.hpp"

#include <dwarf.h>

#include <algorithm>
#include <cstring>
#include <functional>

namespace cb {

std::unique_ptr<DebugInfo> DebugInfo::open(const std::string &file, std::string &why) {
    std::unique_ptr<DebugInfo> info(new DebugInfo());
    info->dwfl_.reset(dwfl_begin(&local_debug_files()));
    Dwfl *dwfl = info->dwfl_.get();
    if (dwfl == nullptr) {
        why = dwfl_errmsg(-1);
        return nullptr;
    }
    dwfl_report_begin(dwfl);
    info->module_ = dwfl_report_offline(dwfl, file.c_str(), file.c_str(), -1);
    if (info->module_ == nullptr) {
        why = dwfl_errmsg(-1);
    }
    dwfl_report_end(dwfl, nullptr, nullptr);
    if (info->module_ == nullptr) {
        return nullptr;
    }
    Dwarf_Addr bias = 0;
    info->dwarf_ = dwfl_module_getdwarf(info->module_, &bias);
    if (info->dwarf_ == nullptr) {
        const char *text = dwfl_errmsg(-1);
        const bool none = text == nullptr || std::strstr(text, "o DWARF information") != nullptr;
        why = none ? "" : text;
        return nullptr;
    }
    // Addresses of symbols are the module's own, those in DWARF the file's; they differ by where
    // Dwfl put it.
    GElf_Addr elf_bias = 0;
    dwfl_module_getelf(info->module_, &elf_bias);
    info->symbol_bias_ = elf_bias;
    info->index();
    if (info->functions_.entries.empty() && info->variables_.entries.empty()) {
        why = "";
        return nullptr;
    }
    return info;
}

void DebugInfo::Table::add(std::string_view name, const Dwarf_Die &die) {
    const auto place = static_cast<std::int32_t>(entries.size());
    const auto [known, is_new] = first.try_emplace(name, place);
    entries.push_back(Entry{name, die, -1});
    if (!is_new) {
        entries.back().next = known->second;
        known->second = place;
    }
}

std::vector<Dwarf_Die> DebugInfo::Table::find(std::string_view name) const {
    std::vector<Dwarf_Die> found;
    const auto known = first.find(name);
    for (std::int32_t i = known == first.end() ? -1 : known->second; i >= 0; i = entries[i].next) {
        found.insert(found.begin(), entries[i].die);
    }
    return found;
}

std::vector<Dwarf_Die> DebugInfo::functions(std::string_view name) const {
    return functions_.find(name);
}

std::vector<Dwarf_Die> DebugInfo::variables(std::string_view name) const {
    return variables_.find(name);
}

std::string_view DebugInfo::keep(std::string text) {
    kept_.push_back(std::move(text));
    return kept_.back();
}

void DebugInfo::index() {
    Dwarf_CU *unit = nullptr;
    Dwarf_Die unit_die;
    Dwarf_Die split_die;
    std::uint8_t type = 0;
    while (dwarf_get_units(dwarf_, unit, &unit, nullptr, &type, &unit_die, &split_die) == 0) {
        if (type == DW_UT_skeleton && split_die.addr != nullptr) {
            index_unit(split_die);
        } else if (type != DW_UT_type) {
            index_unit(unit_die);
        }
    }
    imported_.clear();
}

void DebugInfo::index_unit(Dwarf_Die &unit) {
    if (!in_cxx_unit(unit)) {
        return index_c(unit);
    }
    index_cxx(unit, "");
    if (!waiting_.empty()) {
        name_waiting(unit, "");
    }
    index_nameless();
}

// A unit in the file that dwz -m made of what several files share, if it has not been met yet.
// Units of this very file are met anyway.
std::optional<Dwarf_Die> DebugInfo::foreign_unit(Dwarf_Die &import) {
    auto unit = referenced_die(import, DW_AT_import);
    const bool is_new = unit && dwarf_cu_getdwarf(unit->cu) != dwarf_cu_getdwarf(import.cu) &&
                        imported_.insert(unit->addr).second;
    return is_new ? unit : std::nullopt;
}

void DebugInfo::add(const Dwarf_Die &die, std::string_view name) {
    Dwarf_Die copy = die;
    (dwarf_tag(&copy) == DW_TAG_subprogram ? functions_ : variables_).add(name, die);
}

void DebugInfo::index_c(Dwarf_Die &scope) {
    each_child(scope, [&](Dwarf_Die &die) {
        const int tag = dwarf_tag(&die);
        if (tag == DW_TAG_subprogram || tag == DW_TAG_variable) {
            const char *name = text_attribute(die, DW_AT_name);
            if (name != nullptr && !is_declaration(die)) {
                add(die, name);
            }
        } else if (tag == DW_TAG_imported_unit) {
            if (auto unit = foreign_unit(die)) {
                index_c(*unit);
            }
        }
    });
}

namespace {

// Nobody's code under test, and large.
bool is_runtime_namespace(const char *name) {
    return std::strcmp(name, "std") == 0 || std::strncmp(name, "__", 2) == 0;
}

std::string inside(const std::string &prefix, Dwarf_Die &die) {
    const char *name = dwarf_diename(&die);
    return name != nullptr ? prefix + name + "::" : prefix;
}

bool may_have_definitions(Dwarf_Die &die) {
    const char *name = dwarf_diename(&die);
    return dwarf_tag(&die) == DW_TAG_namespace && (name == nullptr || !is_runtime_namespace(name));
}

bool is_class(Dwarf_Die &die) {
    const int tag = dwarf_tag(&die);
    return tag == DW_TAG_class_type || tag == DW_TAG_structure_type;
}

} // namespace

void DebugInfo::index_cxx(Dwarf_Die &scope, const std::string &prefix) {
    each_child(scope, [&](Dwarf_Die &die) {
        const int tag = dwarf_tag(&die);
        if (tag == DW_TAG_subprogram || tag == DW_TAG_variable) {
            if (!is_declaration(die)) {
                index_cxx_definition(die, prefix);
            }
        } else if (may_have_definitions(die)) {
            index_cxx(die, inside(prefix, die));
        } else if (tag == DW_TAG_imported_unit) {
            if (auto unit = foreign_unit(die)) {
                index_cxx(*unit, prefix);
            }
        }
    });
}

void DebugInfo::index_cxx_definition(Dwarf_Die &die, const std::string &prefix) {
    // From a copy to the abstract function, from that to its declaration.
    std::optional<Dwarf_Die> declaration;
    Dwarf_Die at = die;
    for (unsigned attribute : {DW_AT_abstract_origin, DW_AT_specification}) {
        Dwarf_Attribute own;
        Dwarf_Die origin;
        if (dwarf_attr(&at, attribute, &own) != nullptr &&
            dwarf_formref_die(&own, &origin) != nullptr) {
            declaration = at = origin;
        }
    }
    const char *name = text_attribute(die, DW_AT_name);
    if (declaration) {
        waiting_[declaration->addr].push_back(die);
    } else if (name != nullptr) {
        add(die, prefix.empty() ? std::string_view(name) : keep(prefix + name));
    }
    const char *linkage = text_attribute(die, DW_AT_linkage_name);
    if (linkage != nullptr && (name == nullptr || std::strcmp(name, linkage) != 0)) {
        add(die, linkage);
    }
}

// Gives waiting definitions the qualified names of their declarations in namespaces and classes.
void DebugInfo::name_waiting(Dwarf_Die &scope, const std::string &prefix) {
    each_child(scope, [&](Dwarf_Die &die) {
        if (may_have_definitions(die) || (is_class(die) && dwarf_haschildren(&die) != 0)) {
            return name_waiting(die, inside(prefix, die));
        }
        const auto found = waiting_.find(die.addr);
        const char *name = found != waiting_.end() ? text_attribute(die, DW_AT_name) : nullptr;
        if (name == nullptr) {
            return;
        }
        const std::string_view qualified = prefix.empty() ? name : keep(prefix + name);
        for (const Dwarf_Die &definition : found->second) {
            add(definition, qualified);
        }
        waiting_.erase(found);
    });
}

// What is declared elsewhere (the run-time library's templates) has its linkage name. Only C
// linkage has none.
void DebugInfo::index_nameless() {
    std::vector<Dwarf_Die> left;
    for (const auto &[declaration, definitions] : waiting_) {
        left.insert(left.end(), definitions.begin(), definitions.end());
    }
    waiting_.clear();
    std::sort(left.begin(), left.end(),
              [](const Dwarf_Die &a, const Dwarf_Die &b) { return std::less<>()(a.addr, b.addr); });
    for (Dwarf_Die &die : left) {
        const char *name = text_attribute(die, DW_AT_name);
        if (name != nullptr && text_attribute(die, DW_AT_linkage_name) == nullptr) {
            add(die, name);
        }
    }
}

std::optional<Dwarf_Die> DebugInfo::type(const std::string &name, int tag) {
    if (!types_indexed_) {
        index_types();
        types_indexed_ = true;
    }
    for (Dwarf_Die die : types_.find(name)) {
        const int own = dwarf_tag(&die);
        const bool both_structs = (own == DW_TAG_class_type || own == DW_TAG_structure_type) &&
                                  (tag == DW_TAG_class_type || tag == DW_TAG_structure_type);
        if (tag == 0 || tag == own || both_structs) {
            return die;
        }
    }
    return std::nullopt;
}

void DebugInfo::index_types() {
    Dwarf_CU *unit = nullptr;
    Dwarf_Die unit_die;
    Dwarf_Die split_die;
    std::uint8_t type = 0;
    while (dwarf_get_units(dwarf_, unit, &unit, nullptr, &type, &unit_die, &split_die) == 0) {
        const bool split = type == DW_UT_skeleton && split_die.addr != nullptr;
        index_types_of(split ? split_die : unit_die, "");
    }
}

void DebugInfo::index_types_of(Dwarf_Die &scope, const std::string &prefix) {
    each_child(scope, [&](Dwarf_Die &die) {
        const char *name = dwarf_diename(&die);
        switch (dwarf_tag(&die)) {
        case DW_TAG_imported_unit:
            if (auto unit = foreign_unit(die)) {
                index_types_of(*unit, prefix);
            }
            break;
        case DW_TAG_namespace:
            index_types_of(die, name != nullptr ? prefix + name + "::" : prefix);
            break;
        case DW_TAG_base_type:
        case DW_TAG_typedef:
        case DW_TAG_structure_type:
        case DW_TAG_class_type:
        case DW_TAG_union_type:
        case DW_TAG_enumeration_type:
            if (name != nullptr && !is_declaration(die)) {
                types_.add(prefix.empty() ? std::string_view(name) : keep(prefix + name), die);
            }
            break;
        default:
            break;
        }
    });
}

Location DebugInfo::location(Dwarf_Die &variable) {
    Location location;
    auto attribute = find_attribute(variable, DW_AT_location);
    Dwarf_Op *ops = nullptr;
    std::size_t count = 0;
    if (!attribute || dwarf_getlocation(&*attribute, &ops, &count) != 0 || count == 0) {
        return location;
    }
    const unsigned last = ops[count - 1].atom;
    if (last == DW_OP_form_tls_address || last == DW_OP_GNU_push_tls_address) {
        location.kind = Location::Kind::ThreadLocal;
        return location;
    }
    Dwarf_Attribute indexed;
    Dwarf_Addr address = 0;
    if (ops[0].atom == DW_OP_addr) {
        address = ops[0].number;
    } else if (dwarf_getlocation_attr(&*attribute, &ops[0], &indexed) != 0 ||
               dwarf_formaddr(&indexed, &address) != 0) {
        return location;
    }
    if (count == 2 && last == DW_OP_plus_uconst) {
        address += ops[1].number;
    } else if (count != 1) {
        return location;
    }
    location.kind = address == 0 ? Location::Kind::None : Location::Kind::Address;
    location.address = address;
    return location;
}

std::string DebugInfo::symbol_at(std::uint64_t address) const {
    GElf_Sym symbol;
    GElf_Off offset = 0;
    const char *name = dwfl_module_addrinfo(module_, address + symbol_bias_, &offset, &symbol,
                                            nullptr, nullptr, nullptr);
    return name != nullptr && offset == 0 ? name : "";
}

std::vector<DebugInfo::Symbol> DebugInfo::objects_named(std::string_view prefix) const {
    std::vector<Symbol> found;
    const int count = dwfl_module_getsymtab(module_);
    for (int i = 0; i < count; ++i) {
        GElf_Sym symbol;
        GElf_Addr address = 0;
        const char *name =
            dwfl_module_getsym_info(module_, i, &symbol, &address, nullptr, nullptr, nullptr);
        if (name != nullptr && GELF_ST_TYPE(symbol.st_info) == STT_OBJECT && symbol.st_size > 0 &&
            std::string_view(name).substr(0, prefix.size()) == prefix) {
            found.push_back(Symbol{name, address - symbol_bias_, symbol.st_size});
        }
    }
    return found;
}

unsigned DebugInfo::count_functions_named(std::string_view prefix) const {
    unsigned found = 0;
    const int count = dwfl_module_getsymtab(module_);
    for (int i = 0; i < count; ++i) {
        GElf_Sym symbol;
        const char *name = dwfl_module_getsym(module_, i, &symbol, nullptr);
        found += name != nullptr && GELF_ST_TYPE(symbol.st_info) == STT_FUNC &&
                 std::string_view(name).substr(0, prefix.size()) == prefix;
    }
    return found;
}

} // namespace cb
