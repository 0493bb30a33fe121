// One library under test: what is known of it and what can be done with it.
//
// A session is used by one thread at a time; the front end sees to that. Every operation throws
// Error.
#pragma once

#include "arena.hpp"
#include "convert.hpp"
#include "debug_info.hpp"
#include "ffi_types.hpp"
#include "function.hpp"
#include "library.hpp"
#include "pointers.hpp"
#include "snapshot.hpp"
#include "tree.hpp"
#include "type_table.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace cb {

// What a header's NAME is called in an object of signatures.
inline constexpr std::string_view kSignaturePrefix = "cb_sig_";

struct LoadOptions {
    std::string signatures;            // object file made from headers; empty: none
    std::vector<std::string> no_index; // sonames to leave alone
    std::uint64_t generation = 1;      // the first one, see PointerTable
};

class Session : public ConversionContext {
  public:
    // Loads the library. Throws Error {load, File, no_debug_info | {dlerror, Text} | {debug_info,
    // Text}}.
    Session(const std::string &file, const LoadOptions &options);
    ~Session() override;
    Session(const Session &) = delete;
    Session &operator=(const Session &) = delete;

    // #{file, libraries, reset, warnings}
    Tree description() const;

    // A handle is valid as long as the session.
    std::uint64_t resolve(const std::string &name);
    Function &function(const std::string &name);
    Function &function(std::uint64_t handle);
    // By name or handle, with a short way for atoms that have been used before.
    Function &function(TermReader &reader, Term name_or_handle);
    Arena &arena() {
        return arena_;
    }

    // Memory that lives until the next reset.
    Arena &kept() {
        return kept_;
    }

    // Variables and memory. A path is a list of terms: variable or pointer, then members and
    // indexes.
    void get(TermReader &reader, Term path, TermWriter &writer);
    void set(TermReader &reader, Term path, Term value);
    void address_of(TermReader &reader, Term path, TermWriter &writer);
    void allocate(TermReader &reader, Term type, Term values, TermWriter &writer);
    void free(TermReader &reader, Term pointer);
    void read(TermReader &reader, Term pointer, std::uint64_t count, TermWriter &writer);
    void read_bytes(TermReader &reader, Term pointer, std::uint64_t count, TermWriter &writer);
    void cstring(TermReader &reader, Term pointer, TermWriter &writer);

    Tree functions();
    Tree globals();

    // Frees what was allocated and makes all pointers stale; restore() and reload() do it too.
    void forget_pointers();
    void take_snapshot();
    void restore();
    void reload();
    // Number of libraries whose counters were written (flush) or set to zero.
    unsigned flush_coverage();
    unsigned reset_coverage();

    PointerTable &pointers() override {
        return pointers_;
    }
    void *function_address(const std::string &name) override {
        return function(name).address;
    }
    const Type &type_named(const std::string &spelling) override;

  private:
    // A library under test with its debug information.
    struct Part {
        Mapped mapped;
        std::unique_ptr<DebugInfo> info;
        Snapshot pristine; // as loaded, for the case that a reload leaves it in memory
        std::vector<Range> counters() const; // of coverage
    };
    // Where something lies in a file: an offset in a part, or a symbol for the dynamic linker.
    struct FilePlace {
        std::size_t part = 0;
        std::uint64_t address = 0;
        std::string symbol;
    };
    struct KnownFunction {
        std::unique_ptr<Function> function;
        FilePlace place;
    };
    struct KnownVariable {
        FilePlace place;
        const Type *type;
    };
    // A value in memory: its type, and its place if it is a bit-field (bit_offset counts from
    // address).
    struct Place {
        unsigned char *address = nullptr;
        Member member;
        bool behind_pointer = false; // of the library: it may be anywhere
        // Bytes from address to the end of the value.
        std::size_t extent() const {
            return member.bit_size != 0 ? (member.bit_offset + member.bit_size + 7) / 8
                                        : member.type->size;
        }
    };

    void load_parts(const LoadOptions &options, std::unique_ptr<DebugInfo> main);
    void note_memory();
    void relocate(const std::vector<std::string> &pinned);

    unsigned char *address_in_memory(const FilePlace &place) const;
    std::unique_ptr<KnownFunction> find_function(const std::string &name);
    std::unique_ptr<KnownFunction> find_in_part(std::size_t part, const std::string &name,
                                                std::optional<Tree> &refusal);
    std::unique_ptr<KnownFunction> find_folded(std::size_t part, const std::string &name,
                                               const std::vector<Dwarf_Die> &all);
    std::unique_ptr<KnownFunction> make_function(const std::string &name, Dwarf_Die &die,
                                                 FilePlace place);
    std::optional<Dwarf_Die> signature(const std::string &name) const;
    [[noreturn]] void unknown_function(const std::string &name) const;

    const KnownVariable *find_variable(const std::string &name);
    std::optional<KnownVariable> find_variable_in_files(const std::string &name);
    [[noreturn]] void unknown_variable(const std::string &name) const;
    Place walk(TermReader &reader, Term path);
    void step_member(TermReader &reader, Term path, Term step, const std::string &name,
                     Place &place);
    void step_index(TermReader &reader, Term path, std::int64_t index, Place &place);
    bool is_read_only(const unsigned char *address) const;
    Pointer checked_pointer(TermReader &reader, Term pointer);
    const unsigned char *bytes_behind(const Pointer &pointer, std::size_t size, TermReader &reader,
                                      Term term);
    void follow(TermReader &reader, Term path, Place &place);

    const Type *type_of_base(const std::string &name);
    std::optional<Dwarf_Die> find_type(const std::string &name, int tag);

    std::unique_ptr<LoadedLibrary> library_;
    std::vector<Part> parts_; // the library itself first
    std::unique_ptr<DebugInfo> signatures_;
    TypeTable types_;
    FfiTypes ffi_;
    std::vector<std::unique_ptr<KnownFunction>> known_functions_;
    std::unordered_map<std::string, std::size_t> handles_;
    struct AtomHandle {
        std::uint64_t key = 0;
        Function *function = nullptr;
    };
    std::array<AtomHandle, 256> by_atom_{}; // by a hash of TermReader::atom_key(); the latest wins
    std::unordered_map<std::string, KnownVariable> known_variables_;
    std::unordered_map<std::string, const Type *> known_types_;
    PointerTable pointers_;
    Arena arena_;
    Arena kept_; // buffers behind pointers that were stored in variables; live until the next reset
    unsigned char *path_pointer_ = nullptr; // the pointer a path starts with
    Snapshot snapshot_;
    std::vector<Range> writable_; // of all parts
    std::vector<Range> mapped_;   // of all parts, with what is read-only
};

// {Function, File, Line} for each {Module, Offset, First}; needs no session.
struct Frame {
    std::string module;
    std::uint64_t offset;
    bool exact; // the instruction itself, not the one after a call
};
Tree symbolise(const std::vector<Frame> &frames);

} // namespace cb
