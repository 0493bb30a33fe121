// Functions of a session: from a name to something that can be called, or to the reason why not.
#include "session.hpp"

#include "dwarf_die.hpp"
#include "error.hpp"
#include "suggest.hpp"

#include <dwarf.h>

#include <algorithm>

namespace cb {

namespace {

Tree not_callable(const std::string &name, const char *why) {
    return Tree::tuple({Tree::atom("not_callable"), Tree::atom(name), Tree::atom(why)});
}

// Of a function in several pieces, the first is where it is entered (a cold piece has a symbol of
// its own).
std::uint64_t entry_address(Dwarf_Die &die) {
    Dwarf_Addr base = 0;
    Dwarf_Addr start = 0;
    Dwarf_Addr end = 0;
    if (dwarf_entrypc(&die, &start) == 0 || dwarf_ranges(&die, 0, &base, &start, &end) > 0) {
        return start;
    }
    return 0;
}

// gcc marks copies of a function with another ABI by ".isra.0", ".constprop.0" or ".part.0". These
// suffixes are harmless.
bool changes_abi(const std::string &symbol) {
    const std::size_t dot = symbol.find('.');
    if (dot == std::string::npos) {
        return false;
    }
    const std::string suffix = symbol.substr(dot);
    return suffix.compare(0, 9, ".lto_priv") != 0 && suffix.compare(0, 6, ".llvm.") != 0;
}

// Optimised static functions may have lost parameters that their DIE still lists: those have no
// place.
bool lost_parameters(Dwarf_Die &die) {
    bool lost = false;
    std::size_t own = 0;
    each_child(die, [&](Dwarf_Die &child) {
        if (dwarf_tag(&child) == DW_TAG_formal_parameter) {
            ++own;
            Dwarf_Attribute attribute;
            lost = lost || dwarf_attr(&child, DW_AT_location, &attribute) == nullptr ||
                   find_attribute(child, DW_AT_const_value).has_value();
        }
    });
    std::size_t declared = own;
    if (auto origin = referenced_die(die, DW_AT_abstract_origin)) {
        declared = 0;
        each_child(*origin, [&](Dwarf_Die &child) {
            declared += dwarf_tag(&child) == DW_TAG_formal_parameter ? 1 : 0;
        });
    }
    return lost || own != declared;
}

bool abi_changed(Dwarf_Die &die, const DebugInfo &info, std::uint64_t address) {
    const bool external = has_flag(die, DW_AT_external);
    return unsigned_attribute(die, DW_AT_calling_convention).value_or(0) == DW_CC_nocall ||
           changes_abi(info.symbol_at(address)) || (!external && lost_parameters(die));
}

// Definitions of one name: those with code, exported ones first.
std::vector<Dwarf_Die> definitions(std::vector<Dwarf_Die> found) {
    const auto has_no_code = [](Dwarf_Die &die) { return entry_address(die) == 0; };
    found.erase(std::remove_if(found.begin(), found.end(), has_no_code), found.end());
    std::stable_sort(found.begin(), found.end(), [](const Dwarf_Die &a, const Dwarf_Die &b) {
        Dwarf_Die x = a;
        Dwarf_Die y = b;
        return has_flag(x, DW_AT_external) && !has_flag(y, DW_AT_external);
    });
    return found;
}

// Overloads share a name and differ in linkage names; one of those must be given then.
std::vector<Tree> linkage_names(std::vector<Dwarf_Die> found) {
    std::vector<std::string> names;
    for (Dwarf_Die &die : found) {
        const char *name = text_attribute(die, DW_AT_linkage_name);
        if (name != nullptr && std::find(names.begin(), names.end(), name) == names.end()) {
            names.emplace_back(name);
        }
    }
    std::sort(names.begin(), names.end());
    std::vector<Tree> trees;
    for (const std::string &name : names) {
        trees.push_back(Tree::atom(name));
    }
    return trees;
}

} // namespace

std::uint64_t Session::resolve(const std::string &name) {
    const auto known = handles_.find(name);
    if (known != handles_.end()) {
        return known->second;
    }
    known_functions_.push_back(find_function(name));
    const std::size_t handle = known_functions_.size() - 1;
    handles_.emplace(name, handle);
    return handle;
}

Function &Session::function(const std::string &name) {
    return *known_functions_[resolve(name)]->function;
}

Function &Session::function(std::uint64_t handle) {
    if (handle >= known_functions_.size()) {
        fail("unknown_handle", Tree::integer(static_cast<std::int64_t>(handle)));
    }
    return *known_functions_[handle]->function;
}

Function &Session::function(TermReader &reader, Term name_or_handle) {
    std::uint64_t number = 0;
    std::string name;
    if (reader.atom_key(name_or_handle, number)) {
        AtomHandle &known = by_atom_[(number >> 6) % by_atom_.size()];
        if (known.key != number) {
            read_text(reader, name_or_handle, name);
            known.function = &function(name);
            known.key = number;
        }
        return *known.function;
    }
    if (reader.read_unsigned(name_or_handle, number)) {
        return function(number);
    }
    if (!read_text(reader, name_or_handle, name)) {
        fail("bad_request", Tree::foreign(reader, name_or_handle));
    }
    return function(name);
}

std::unique_ptr<Session::KnownFunction> Session::find_function(const std::string &name) {
    std::optional<Tree> refusal;
    for (std::size_t part = 0; part < parts_.size(); ++part) {
        std::unique_ptr<KnownFunction> found = find_in_part(part, name, refusal);
        if (found != nullptr) {
            return found;
        }
    }
    if (auto prototype = signature(name)) {
        auto known = make_function(name, *prototype, FilePlace{0, 0, name});
        if (known->function->address != nullptr) {
            return known;
        }
    }
    if (refusal) {
        throw Error(*refusal);
    }
    unknown_function(name);
}

std::unique_ptr<Session::KnownFunction>
Session::find_in_part(std::size_t part, const std::string &name, std::optional<Tree> &refusal) {
    const DebugInfo *info = parts_[part].info.get();
    if (info == nullptr) {
        return nullptr;
    }
    const std::vector<Dwarf_Die> all = info->functions(name);
    std::vector<Dwarf_Die> found = definitions(all);
    if (found.empty()) {
        if (auto folded = find_folded(part, name, all)) {
            return folded;
        }
        if (!all.empty() && !refusal) {
            refusal = not_callable(name, "inlined");
        }
        return nullptr;
    }
    std::vector<Tree> overloads = linkage_names(found);
    if (overloads.size() > 1) {
        fail("unknown_function", Tree::atom(name), Tree::list(std::move(overloads)));
    }
    Dwarf_Die &die = found.front();
    const std::uint64_t address = entry_address(die);
    if (abi_changed(die, *info, address)) {
        refusal = not_callable(name, "abi_changed");
        return nullptr;
    }
    return make_function(name, die, FilePlace{part, address, ""});
}

// Two exported functions with the same code may be one: then only a symbol is left of the other.
std::unique_ptr<Session::KnownFunction>
Session::find_folded(std::size_t part, const std::string &name, const std::vector<Dwarf_Die> &all) {
    for (Dwarf_Die die : all) {
        const char *linkage = text_attribute(die, DW_AT_linkage_name);
        const std::string symbol = linkage != nullptr ? linkage : name;
        void *address = LoadedLibrary::symbol_of(parts_[part].mapped, symbol.c_str());
        if (address != nullptr && has_flag(die, DW_AT_external)) {
            const auto in_memory = reinterpret_cast<std::uintptr_t>(address);
            return make_function(name, die,
                                 FilePlace{part, in_memory - parts_[part].mapped.bias, ""});
        }
    }
    return nullptr;
}

std::unique_ptr<Session::KnownFunction> Session::make_function(const std::string &name,
                                                               Dwarf_Die &die, FilePlace place) {
    auto known = std::make_unique<KnownFunction>();
    known->place = std::move(place);
    known->function = std::make_unique<Function>(name, read_prototype(die, types_), ffi_);
    known->function->address = address_in_memory(known->place);
    return known;
}

// Objects made from headers hold a variable `cb_sig_NAME` for each NAME, a pointer to what NAME is.
std::optional<Dwarf_Die> Session::signature(const std::string &name) const {
    if (signatures_ == nullptr) {
        return std::nullopt;
    }
    for (Dwarf_Die &variable : signatures_->variables(std::string(kSignaturePrefix) + name)) {
        auto pointer = referenced_die(variable, DW_AT_type);
        auto target = pointer ? referenced_die(*pointer, DW_AT_type) : std::nullopt;
        if (target && dwarf_tag(&*target) == DW_TAG_subroutine_type) {
            return target;
        }
    }
    return std::nullopt;
}

void Session::unknown_function(const std::string &name) const {
    Suggestions close(name);
    for (const Part &part : parts_) {
        if (part.info != nullptr) {
            part.info->each_function(
                [&](std::string_view candidate, Dwarf_Die &) { close.offer(candidate); });
        }
    }
    if (signatures_ != nullptr) {
        signatures_->each_variable([&](std::string_view candidate, Dwarf_Die &) {
            close.offer(candidate.substr(std::min(candidate.size(), kSignaturePrefix.size())));
        });
    }
    fail("unknown_function", Tree::atom(name), close.tree());
}

} // namespace cb
