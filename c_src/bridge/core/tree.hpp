// A small term built by the core itself: reasons of errors and replies that are not on the hot
// path.
#pragma once

#include "term.hpp"

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace cb {

class Tree {
  public:
    // Texts of 256 bytes and more cannot be atoms and become binaries.
    static Tree atom(std::string text);
    static Tree binary(std::string bytes);
    static Tree integer(std::int64_t value);
    static Tree tuple(std::vector<Tree> elements);
    static Tree list(std::vector<Tree> elements);
    // Keys and values in turn.
    static Tree map(std::vector<Tree> keys_and_values);
    // A term of the request; the tree must not outlive the request.
    static Tree foreign(TermReader &reader, Term term);
    // A list of terms that a writer had written already (TermWriter::written).
    static Tree written_list(std::string terms, unsigned count);

    void write(TermWriter &writer) const;
    // A copy that holds no term of a request any more: such terms become `_`, unless they are
    // small.
    Tree owned() const;
    // The tree in Erlang's notation, for people (foreign terms are shown as `_`).
    std::string text() const;

  private:
    enum class Shape { Atom, Binary, Integer, Tuple, List, Map, Foreign, WrittenList };
    Shape shape_ = Shape::Atom;
    std::string text_;
    std::int64_t integer_ = 0;
    std::vector<Tree> elements_;
    TermReader *reader_ = nullptr;
    Term term_ = 0;
};

} // namespace cb
