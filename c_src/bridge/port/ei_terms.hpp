// Terms in the external term format for the core.
#pragma once

#include "../core/term.hpp"

#include <cstdint>
#include <ei.h>

#include <vector>

namespace cb {

// A Term is the offset of its tag; an element of STRING_EXT, which has no tag, is its offset and
// kByte.
class EiReader final : public TermReader {
  public:
    // Checks all of the message. Throws MalformedTerm. The bytes must outlive what is read from
    // them.
    void begin(const char *bytes, std::size_t size);
    // The one term of the message.
    Term root() const {
        return 1;
    }

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

    // The bytes of a term, empty for an element of a STRING_EXT.
    std::string_view raw(Term term) const;
    static bool is_byte(Term term) {
        return (term & kByte) != 0;
    }

  private:
    static constexpr Term kByte = Term{1} << 63;
    unsigned char byte_at(Term term) const {
        return static_cast<unsigned char>(bytes_[term & ~kByte]);
    }
    std::size_t end_of(Term term) const;

    const char *bytes_ = nullptr;
    std::size_t size_ = 0;
    char atom_[MAXATOMLEN_UTF8];
};

// A packet under construction: four bytes for its length, then one term.
class EiWriter final : public TermWriter {
  public:
    EiWriter();
    ~EiWriter() override;
    EiWriter(const EiWriter &) = delete;
    EiWriter &operator=(const EiWriter &) = delete;

    void begin();
    // The packet, its length filled in.
    std::string_view packet();

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
    ei_x_buff buffer_{};
    std::vector<bool> open_lists_; // for each open term: is it a list?
};

} // namespace cb
