// Checking the external term format before ei, which does not know where its buffer ends, reads it.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace cb {

class MalformedTerm : public std::runtime_error {
  public:
    MalformedTerm(const std::string &what, std::size_t offset)
        : std::runtime_error(what + " at byte " + std::to_string(offset)) {}
};

// Offset behind the term that starts at `offset`. Throws MalformedTerm when it is cut off, nested
// deeper than 256, or of a kind that term_to_binary/1 does not write.
std::size_t end_of_term(const char *bytes, std::size_t size, std::size_t offset);

} // namespace cb
