// The external term format: what is written is read back; what is cut off or damaged is refused,
// never overrun.
#include "check.h"

#include "../port/ei_terms.hpp"
#include "../port/external_term.hpp"

#include <string>
#include <vector>

using namespace cb;

namespace {

// One of each kind of term, as OTP 25 writes it.
std::string sample() {
    EiWriter writer;
    writer.begin_tuple(8);
    writer.write_signed(-5);
    writer.write_unsigned(18446744073709551615ULL);
    writer.write_float(1.5);
    writer.write_atom("an_atom");
    writer.write_binary("bytes");
    writer.begin_list(2);
    writer.write_signed(300);
    writer.begin_list(0);
    writer.end();
    writer.end();
    writer.begin_map(1);
    writer.write_atom("key");
    writer.write_signed(255);
    writer.end();
    writer.begin_tuple(0);
    writer.end();
    writer.end();
    return std::string(writer.packet().substr(4));
}

void what_is_written_is_read_back() {
    const std::string bytes = sample();
    EiReader reader;
    reader.begin(bytes.data(), bytes.size());
    Term part[8];
    unsigned count = 0;
    CHECK(reader.read_tuple(reader.root(), part, 8, count) && count == 8);
    CHECK(!reader.read_tuple(reader.root(), part, 7, count));
    CHECK(reader.read_tuple(reader.root(), part, 8, count));
    std::int64_t number = 0;
    CHECK(reader.read_signed(part[0], number) && number == -5);
    std::uint64_t wide = 0;
    CHECK(!reader.read_signed(part[1], number));
    CHECK(reader.read_unsigned(part[1], wide) && wide == 18446744073709551615ULL);
    double real = 0;
    CHECK(reader.read_float(part[2], real) && real == 1.5);
    CHECK(reader.is_atom(part[3], "an_atom") && !reader.is_atom(part[3], "an_atoms"));
    CHECK(!reader.is_atom(part[4], "bytes"));
    std::string_view text;
    CHECK(reader.read_binary(part[4], text) && text == "bytes");
    ListCursor list;
    CHECK(reader.read_list(part[5], list) && list.left == 2);
    CHECK(reader.read_signed(reader.next(list), number) && number == 300);
    ListCursor empty;
    CHECK(reader.read_list(reader.next(list), empty) && empty.left == 0);
    MapEntries entries;
    CHECK(reader.read_map(part[6], entries) && entries.size() == 1);
    CHECK(reader.is_atom(entries[0].first, "key"));
    CHECK(reader.read_signed(entries[0].second, number) && number == 255);
    CHECK(reader.kind(part[7]) == TermKind::Tuple);
}

void strings_are_lists_of_bytes() {
    const std::string bytes("\x83k\0\3abc", 7);
    EiReader reader;
    reader.begin(bytes.data(), bytes.size());
    ListCursor list;
    CHECK(reader.read_list(reader.root(), list) && list.left == 3);
    const Term first = reader.next(list);
    std::int64_t number = 0;
    CHECK(reader.kind(first) == TermKind::Integer);
    CHECK(reader.read_signed(first, number) && number == 'a');
    std::string text;
    CHECK(read_text(reader, reader.root(), text) && text == "abc");
}

void improper_lists_are_no_lists() {
    const std::string bytes("\x83l\0\0\0\1a\1a\2", 10);
    EiReader reader;
    reader.begin(bytes.data(), bytes.size());
    ListCursor list;
    CHECK(!reader.read_list(reader.root(), list));
    CHECK(reader.kind(reader.root()) == TermKind::List);
}

bool refused(const std::string &bytes) {
    try {
        EiReader reader;
        reader.begin(bytes.data(), bytes.size());
        return false;
    } catch (const MalformedTerm &) {
        return true;
    }
}

// Reads everything a damaged but complete message has to offer.
void read_all(EiReader &reader, Term term, int depth) {
    std::int64_t number = 0;
    std::uint64_t wide = 0;
    double real = 0;
    std::string_view text;
    Term parts[4];
    unsigned count = 0;
    ListCursor list;
    MapEntries entries;
    if (depth > 20 || reader.read_signed(term, number) || reader.read_unsigned(term, wide) ||
        reader.read_float(term, real) || reader.read_atom(term, text) ||
        reader.read_binary(term, text)) {
        return;
    }
    if (reader.read_tuple(term, parts, 4, count)) {
        for (unsigned i = 0; i < count; ++i) {
            read_all(reader, parts[i], depth + 1);
        }
    } else if (reader.read_list(term, list)) {
        while (list.left > 0) {
            read_all(reader, reader.next(list), depth + 1);
        }
    } else if (reader.read_map(term, entries)) {
        for (const auto &[key, value] : entries) {
            read_all(reader, key, depth + 1);
            read_all(reader, value, depth + 1);
        }
    }
}

void damaged_messages_are_refused_or_read_within_their_bounds() {
    const std::string good = sample();
    for (std::size_t size = 0; size < good.size(); ++size) {
        CHECK(refused(good.substr(0, size)));
    }
    CHECK(refused(good + "x"));
    for (std::size_t at = 1; at < good.size(); ++at) {
        for (int value = 0; value < 256; ++value) {
            std::string bad = good;
            bad[at] = static_cast<char>(value);
            if (!refused(bad)) {
                const std::vector<char> exact(bad.begin(),
                                              bad.end()); // its end is the end of a block of memory
                EiReader reader;
                reader.begin(exact.data(), exact.size());
                read_all(reader, reader.root(), 0);
            }
        }
    }
    std::string deep = "\x83";
    for (int i = 0; i < 1000; ++i) {
        deep += std::string("h\1", 2);
    }
    CHECK(refused(deep + "j"));
}

} // namespace

int main() {
    what_is_written_is_read_back();
    strings_are_lists_of_bytes();
    improper_lists_are_no_lists();
    damaged_messages_are_refused_or_read_within_their_bounds();
    return check_failures != 0;
}
