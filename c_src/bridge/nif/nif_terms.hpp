// Terms of the virtual machine for the core.
#pragma once

#include "../core/term.hpp"

#include <cstdint>
#include <erl_nif.h>

#include <cstring>

namespace cb {

class NifReader final : public TermReader {
  public:
    void begin(ErlNifEnv *env) {
        env_ = env;
    }
    TermKind kind(Term term) override;
    bool read_signed(Term term, std::int64_t &out) override;
    bool read_unsigned(Term term, std::uint64_t &out) override;
    bool read_float(Term term, double &out) override;
    bool read_atom(Term term, std::string_view &out) override;
    bool is_atom(Term term, const Name &name) override;
    bool atom_key(Term term, std::uint64_t &out) override;
    bool read_binary(Term term, std::string_view &out) override;
    bool read_tuple(Term term, Term *out, unsigned max, unsigned &count) override;
    bool read_list(Term term, ListCursor &out) override;
    Term next(ListCursor &cursor) override;
    bool read_map(Term term, MapEntries &out) override;

  private:
    ErlNifEnv *env_ = nullptr;
    char atom_[256];
};

class NifWriter final : public TermWriter {
  public:
    void begin(ErlNifEnv *env) {
        env_ = env;
        terms_.clear();
        open_.clear();
    }
    // The one term that has been written.
    ERL_NIF_TERM result() const {
        return terms_.back();
    }
    void write_signed(std::int64_t value) override;
    void write_unsigned(std::uint64_t value) override;
    void write_float(double value) override;
    void write_atom(std::string_view text) override;
    void write_name(const Name &name) override;
    void write_binary(std::string_view bytes) override;
    void begin_tuple(unsigned count) override;
    void begin_list(unsigned count) override;
    void begin_map(unsigned count) override;
    void end() override;
    void write_term(TermReader &reader, Term term) override;
    std::size_t mark() override;
    std::string written(std::size_t from, std::size_t to) override;
    void write_again(const std::string &terms) override;

  private:
    enum class Shape { Tuple, List, Map };
    struct Open {
        Shape shape;
        std::size_t start;
    };
    ERL_NIF_TERM make_map(const ERL_NIF_TERM *pairs, std::size_t count);

    ErlNifEnv *env_ = nullptr;
    std::vector<ERL_NIF_TERM> terms_;
    std::vector<Open> open_;
};

// The atom of a name, remembered in it: atoms are the same for the life of the virtual machine.
inline ERL_NIF_TERM atom_of(ErlNifEnv *env, const Name &name) {
    std::uint64_t known = name.cache.load(std::memory_order_relaxed);
    if (known == 0) {
        known = enif_make_atom_len(env, name.text().data(), name.text().size());
        name.cache.store(known, std::memory_order_relaxed);
    }
    return known;
}

} // namespace cb
