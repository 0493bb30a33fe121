// Terms written as Erlang writes them, for tests: requests and replies are texts.
#pragma once

#include "../core/term.hpp"

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

namespace cb {

struct TextTerm {
    TermKind kind = TermKind::Other;
    std::string text; // of atoms and binaries; of integers that fit no machine word
    bool negative = false;
    bool wide = false; // does not fit 64 bits
    std::uint64_t magnitude = 0;
    double number = 0;
    bool proper = true;
    std::vector<const TextTerm *> elements; // of tuples and lists; keys and values in turn of maps
};

class TextReader final : public TermReader {
  public:
    // Aborts on text that is not a term: tests are written by people.
    Term parse(const std::string &text);
    TermKind kind(Term term) override;
    bool read_signed(Term term, std::int64_t &out) override;
    bool read_unsigned(Term term, std::uint64_t &out) override;
    bool read_float(Term term, double &out) override;
    bool read_atom(Term term, std::string_view &out) override;
    bool is_atom(Term term, const Name &name) override;
    bool read_binary(Term term, std::string_view &out) override;
    bool read_tuple(Term term, Term *out, unsigned max, unsigned &count) override;
    bool read_list(Term term, ListCursor &out) override;
    Term next(ListCursor &cursor) override;
    bool read_map(Term term, MapEntries &out) override;

  private:
    const TextTerm *term();
    const TextTerm *number();
    std::string quoted(char end);
    void elements(TextTerm &into, char close);
    void skip_blanks();
    TextTerm &make(TermKind kind);

    std::deque<TextTerm> terms_;
    std::string source_;
    std::size_t at_ = 0;
};

class TextWriter final : public TermWriter {
  public:
    const std::string &text() const {
        return text_;
    }
    void begin() {
        text_.clear();
        open_.clear();
        comma_ = false;
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
    void put(const std::string &text);
    std::string text_;
    std::vector<char> open_;
    std::vector<unsigned> places_; // of keys and values in maps
    bool comma_ = false;
};

} // namespace cb
