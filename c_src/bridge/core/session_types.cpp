// C types by their spelling.
#include "session.hpp"

#include "error.hpp"

#include <dwarf.h>

#include <algorithm>
#include <cctype>

namespace cb {

namespace {

constexpr std::uint64_t kLargestType = 256U << 20;

struct Spelling {
    std::string base; // words apart by one space, without qualifiers
    unsigned stars = 0;
    std::vector<std::uint64_t> dimensions;
};

bool is_qualifier(const std::string &word) {
    return word == "const" || word == "volatile" || word == "restrict" || word == "register";
}

// "const struct point * [3]" and the like; false if that is not the form of it.
bool parse(const std::string &text, Spelling &out) {
    std::size_t i = 0;
    while (i < text.size()) {
        const char c = text[i];
        if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            ++i;
        } else if (c == '*') {
            ++out.stars;
            ++i;
        } else if (c == '[') {
            const std::size_t close = text.find(']', i);
            if (close == std::string::npos || close == i + 1 || close - i > 10 ||
                text.find_first_not_of("0123456789", i + 1) != close) {
                return false;
            }
            out.dimensions.push_back(std::stoull(text.substr(i + 1, close - i - 1)));
            i = close + 1;
        } else {
            const std::size_t end = std::min(text.find_first_of(" *[\t", i), text.size());
            const std::string word = text.substr(i, end - i);
            if (!is_qualifier(word)) {
                if (out.stars > 0 || !out.dimensions.empty()) {
                    return false;
                }
                out.base += (out.base.empty() ? "" : " ") + word;
            }
            i = end;
        }
    }
    return !out.base.empty();
}

} // namespace

std::optional<Dwarf_Die> Session::find_type(const std::string &name, int tag) {
    for (const Part &part : parts_) {
        auto found = part.info != nullptr ? part.info->type(name, tag) : std::nullopt;
        if (found) {
            return found;
        }
    }
    return signatures_ != nullptr ? signatures_->type(name, tag) : std::nullopt;
}

const Type *Session::type_of_base(const std::string &name) {
    const std::size_t space = name.find(' ');
    const std::string first = name.substr(0, space);
    const int tag = first == "struct"  ? DW_TAG_structure_type
                    : first == "union" ? DW_TAG_union_type
                    : first == "enum"  ? DW_TAG_enumeration_type
                                       : 0;
    const std::string plain =
        tag == 0 || space == std::string::npos ? name : name.substr(space + 1);
    if (auto found = find_type(plain, tag)) {
        return &types_.of(*found);
    }
    const Type *known = types_.built_in(name);
    if (known == nullptr) { // eqc_c writes unsigned_char
        std::string spaced = name;
        std::replace(spaced.begin(), spaced.end(), '_', ' ');
        known = spaced == name ? nullptr : types_.built_in(spaced);
    }
    return known;
}

const Type &Session::type_named(const std::string &text) {
    const auto known = known_types_.find(text);
    if (known != known_types_.end()) {
        return *known->second;
    }
    Spelling spelling;
    const Type *type = parse(text, spelling) ? type_of_base(spelling.base) : nullptr;
    if (type == nullptr) {
        fail("unknown_type", Tree::atom(text));
    }
    for (unsigned i = 0; i < spelling.stars; ++i) {
        type = &types_.pointer_to(*type);
    }
    for (auto size = spelling.dimensions.rbegin(); size != spelling.dimensions.rend(); ++size) {
        if (type->size != 0 && *size > kLargestType / type->size) {
            fail("unknown_type", Tree::atom(text));
        }
        type = &types_.array_of(*type, *size);
    }
    return *(known_types_[text] = type);
}

} // namespace cb
