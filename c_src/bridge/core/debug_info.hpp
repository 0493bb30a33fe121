// The debug information of one file (library or object) and an index of what it names.
#pragma once

#include <elfutils/libdwfl.h>

#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace cb {

// Where a variable lies.
struct Location {
    enum class Kind { Address, ThreadLocal, None } kind = Kind::None;
    std::uint64_t address = 0; // as in the file
};

class DebugInfo {
  public:
    // nullptr if the file has no debug information that can be found on this machine; `why` says
    // what went wrong, or is empty if there simply is none. Never asks the network.
    static std::unique_ptr<DebugInfo> open(const std::string &file, std::string &why);

    // All functions or variables of that name: plain, qualified ("ns::f") or linkage name.
    std::vector<Dwarf_Die> functions(std::string_view name) const;
    std::vector<Dwarf_Die> variables(std::string_view name) const;
    // Calls visit(name, die) for each DIE under each of its names.
    template <typename Visit> void each_function(Visit visit) const {
        each(functions_, visit);
    }
    template <typename Visit> void each_variable(Visit visit) const {
        each(variables_, visit);
    }
    // A complete type by its name without "struct"; `tag` is 0 for any.
    std::optional<Dwarf_Die> type(const std::string &name, int tag);

    static Location location(Dwarf_Die &variable);
    // Name of the ELF symbol that covers this address of the file; empty if none.
    std::string symbol_at(std::uint64_t address) const;

    struct Symbol {
        std::string_view name;
        std::uint64_t address;
        std::uint64_t size;
    };
    std::vector<Symbol> objects_named(std::string_view prefix) const;
    unsigned count_functions_named(std::string_view prefix) const;

  private:
    struct Entry {
        std::string_view name;
        Dwarf_Die die;
        std::int32_t next; // same name; -1: none
    };
    struct Table {
        std::vector<Entry> entries;
        std::unordered_map<std::string_view, std::int32_t> first;
        void add(std::string_view name, const Dwarf_Die &die);
        std::vector<Dwarf_Die> find(std::string_view name) const;
    };
    template <typename Visit> static void each(const Table &table, Visit visit) {
        for (const Entry &entry : table.entries) {
            Dwarf_Die die = entry.die;
            visit(entry.name, die);
        }
    }
    struct DwflEnd {
        void operator()(Dwfl *dwfl) const {
            dwfl_end(dwfl);
        }
    };

    DebugInfo() = default;
    void index();
    void index_unit(Dwarf_Die &unit);
    void index_c(Dwarf_Die &scope);
    void index_cxx(Dwarf_Die &scope, const std::string &prefix);
    void index_cxx_definition(Dwarf_Die &die, const std::string &prefix);
    void name_waiting(Dwarf_Die &scope, const std::string &prefix);
    void index_nameless();
    void add(const Dwarf_Die &die, std::string_view name);
    std::optional<Dwarf_Die> foreign_unit(Dwarf_Die &import);
    void index_types();
    void index_types_of(Dwarf_Die &scope, const std::string &prefix);
    std::string_view keep(std::string text);

    std::unique_ptr<Dwfl, DwflEnd> dwfl_;
    Dwfl_Module *module_ = nullptr;
    Dwarf *dwarf_ = nullptr;
    Dwarf_Addr symbol_bias_ = 0;
    Table functions_;
    Table variables_;
    Table types_;
    bool types_indexed_ = false;
    std::deque<std::string> kept_;
    // C++ definitions by the declaration they complete, which has their qualified name; of one unit
    // at a time.
    std::unordered_map<void *, std::vector<Dwarf_Die>> waiting_;
    // Units of a file that dwz made of what several files share, and that have been indexed.
    std::unordered_set<void *> imported_;
};

} // namespace cb
