// Names close to a mistyped one.
#pragma once

#include "tree.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace cb {

class Suggestions {
  public:
    explicit Suggestions(std::string wanted) : wanted_(std::move(wanted)) {}
    void offer(std::string_view candidate);
    // At most three, the closest first.
    Tree tree() const;

  private:
    struct Candidate {
        unsigned distance;
        std::string name;
    };
    std::string wanted_;
    std::vector<Candidate> best_;
};

// Levenshtein distance, or `limit + 1` when it is larger than `limit`.
unsigned edit_distance(std::string_view a, std::string_view b, unsigned limit);

} // namespace cb
