#include "term.hpp"

namespace cb {

bool read_text(TermReader &reader, Term term, std::string &out) {
    std::string_view text;
    if (reader.read_atom(term, text) || reader.read_binary(term, text)) {
        out.assign(text);
        return true;
    }
    ListCursor cursor;
    if (!reader.read_list(term, cursor) || cursor.left == 0) {
        return false;
    }
    std::string collected;
    collected.reserve(cursor.left);
    while (cursor.left > 0) {
        std::uint64_t character = 0;
        if (!reader.read_unsigned(reader.next(cursor), character) || character == 0 ||
            character > 255) {
            return false;
        }
        collected.push_back(static_cast<char>(character));
    }
    out = std::move(collected);
    return true;
}

} // namespace cb
