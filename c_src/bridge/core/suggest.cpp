#include "suggest.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace cb {

constexpr std::size_t kMostSuggestions = 3;

unsigned edit_distance(std::string_view a, std::string_view b, unsigned limit) {
    const std::size_t longer = std::max(a.size(), b.size());
    if (longer - std::min(a.size(), b.size()) > limit) {
        return limit + 1;
    }
    std::vector<unsigned> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0U);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        unsigned diagonal = row[0];
        row[0] = static_cast<unsigned>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const unsigned replaced = diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U);
            diagonal = row[j];
            row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
        }
    }
    return std::min(row[b.size()], limit + 1);
}

void Suggestions::offer(std::string_view candidate) {
    const auto limit = static_cast<unsigned>(std::max<std::size_t>(2, wanted_.size() / 3));
    const unsigned distance = edit_distance(wanted_, candidate, limit);
    if (distance > limit || distance >= wanted_.size()) {
        return;
    }
    const auto same = [&](const Candidate &known) { return known.name == candidate; };
    if (std::any_of(best_.begin(), best_.end(), same)) {
        return;
    }
    const Candidate offered{distance, std::string(candidate)};
    const auto closer = [](const Candidate &a, const Candidate &b) {
        return std::tie(a.distance, a.name) < std::tie(b.distance, b.name);
    };
    const auto place = std::upper_bound(best_.begin(), best_.end(), offered, closer);
    best_.insert(place, offered);
    if (best_.size() > kMostSuggestions) {
        best_.pop_back();
    }
}

Tree Suggestions::tree() const {
    std::vector<Tree> names;
    for (const Candidate &candidate : best_) {
        names.push_back(Tree::atom(candidate.name));
    }
    return Tree::list(std::move(names));
}

} // namespace cb
