// What a front end supplies: reading a request's terms and writing a reply's terms.
//
// The core never sees how terms are stored. A Term is a number that means something to its reader
// only (a NIF term, an offset into a message) and lives as long as the request.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cb {

using Term = std::uint64_t;

enum class TermKind { Integer, Float, Atom, Binary, Tuple, List, Map, Other };

// The text of an atom, with room for a front end to remember its own form of it.
class Name {
  public:
    Name() = default;
    Name(std::string text) : text_(std::move(text)) {}
    Name(const char *text) : text_(text) {}
    Name(const Name &other)
        : text_(other.text_), cache(other.cache.load(std::memory_order_relaxed)) {}
    Name &operator=(const Name &other) {
        text_ = other.text_;
        cache.store(other.cache.load(std::memory_order_relaxed), std::memory_order_relaxed);
        return *this;
    }
    const std::string &text() const {
        return text_;
    }

  private:
    std::string text_;

  public:
    mutable std::atomic<std::uint64_t> cache{0}; // 0: not yet made
};

// A place in a proper list: `left` elements from `at` on.
struct ListCursor {
    Term at = 0;
    std::uint32_t left = 0;
};

using MapEntries = std::vector<std::pair<Term, Term>>;

// Each reading function returns false, and leaves its output alone, when the term is of another
// kind (or the integer does not fit). A string_view is valid until the next call of the same
// function.
class TermReader {
  public:
    virtual ~TermReader() = default;
    virtual TermKind kind(Term term) = 0;
    virtual bool read_signed(Term term, std::int64_t &out) = 0;
    virtual bool read_unsigned(Term term, std::uint64_t &out) = 0;
    virtual bool read_float(Term term, double &out) = 0;
    virtual bool read_atom(Term term, std::string_view &out) = 0;
    virtual bool is_atom(Term term, const Name &name) = 0;
    // A number that stands for this atom as long as the program runs, where there is one that costs
    // nothing.
    virtual bool atom_key(Term, std::uint64_t &) {
        return false;
    }
    virtual bool read_binary(Term term, std::string_view &out) = 0;
    // Elements of a tuple; false too when it has more than `max`.
    virtual bool read_tuple(Term term, Term *out, unsigned max, unsigned &count) = 0;
    virtual bool read_list(Term term, ListCursor &out) = 0;
    virtual Term next(ListCursor &cursor) = 0;
    virtual bool read_map(Term term, MapEntries &out) = 0;
};

// Terms are written outside in. begin_* is told the number of elements (of pairs for a map) and
// closed by end().
class TermWriter {
  public:
    virtual ~TermWriter() = default;
    virtual void write_signed(std::int64_t value) = 0;
    virtual void write_unsigned(std::uint64_t value) = 0;
    virtual void write_float(double value) = 0; // finite
    virtual void write_atom(std::string_view text) = 0;
    virtual void write_name(const Name &name) = 0;
    virtual void write_binary(std::string_view bytes) = 0;
    virtual void begin_tuple(unsigned count) = 0;
    virtual void begin_list(unsigned count) = 0;
    virtual void begin_map(unsigned count) = 0;
    virtual void end() = 0;
    // Writes a term of the request as it came.
    virtual void write_term(TermReader &reader, Term term) = 0;
    // Complete terms that were written between two marks, to be written again later (even after an
    // error).
    virtual std::size_t mark() = 0;
    virtual std::string written(std::size_t from, std::size_t to) = 0;
    virtual void write_again(const std::string &terms) = 0;
};

// The text of an atom, a binary or a list of characters 1..255 (a name may be given as any of
// these).
bool read_text(TermReader &reader, Term term, std::string &out);

} // namespace cb
