#include "ei_terms.hpp"

#include "external_term.hpp"

#include <cstring>
#include <new>

namespace cb {

namespace {

constexpr unsigned char kVersion = 131; // of the external term format

} // namespace

void EiReader::begin(const char *bytes, std::size_t size) {
    if (size < 2 || static_cast<unsigned char>(bytes[0]) != kVersion) {
        throw MalformedTerm("no version byte 131", 0);
    }
    const std::size_t end = end_of_term(bytes, size, 1);
    if (end != size) {
        throw MalformedTerm("bytes behind the term", end);
    }
    bytes_ = bytes;
    size_ = size;
}

std::size_t EiReader::end_of(Term term) const {
    return end_of_term(bytes_, size_, term);
}

TermKind EiReader::kind(Term term) {
    if (is_byte(term)) {
        return TermKind::Integer;
    }
    switch (byte_at(term)) {
    case ERL_SMALL_INTEGER_EXT:
    case ERL_INTEGER_EXT:
    case ERL_SMALL_BIG_EXT:
    case ERL_LARGE_BIG_EXT:
        return TermKind::Integer;
    case ERL_FLOAT_EXT:
    case NEW_FLOAT_EXT:
        return TermKind::Float;
    case ERL_ATOM_EXT:
    case ERL_SMALL_ATOM_EXT:
    case ERL_ATOM_UTF8_EXT:
    case ERL_SMALL_ATOM_UTF8_EXT:
        return TermKind::Atom;
    case ERL_BINARY_EXT:
        return TermKind::Binary;
    case ERL_SMALL_TUPLE_EXT:
    case ERL_LARGE_TUPLE_EXT:
        return TermKind::Tuple;
    case ERL_LIST_EXT:
    case ERL_NIL_EXT:
    case ERL_STRING_EXT:
        return TermKind::List;
    case ERL_MAP_EXT:
        return TermKind::Map;
    default:
        return TermKind::Other;
    }
}

bool EiReader::read_signed(Term term, std::int64_t &out) {
    if (is_byte(term)) {
        out = byte_at(term);
        return true;
    }
    if (byte_at(term) == ERL_SMALL_INTEGER_EXT) {
        out = byte_at(term + 1);
        return true;
    }
    int index = static_cast<int>(term);
    long long value = 0;
    if (kind(term) != TermKind::Integer || ei_decode_longlong(bytes_, &index, &value) != 0) {
        return false;
    }
    out = value;
    return true;
}

bool EiReader::read_unsigned(Term term, std::uint64_t &out) {
    if (is_byte(term)) {
        out = byte_at(term);
        return true;
    }
    int index = static_cast<int>(term);
    unsigned long long value = 0;
    if (kind(term) != TermKind::Integer || ei_decode_ulonglong(bytes_, &index, &value) != 0) {
        return false;
    }
    out = value;
    return true;
}

bool EiReader::read_float(Term term, double &out) {
    int index = static_cast<int>(term);
    return kind(term) == TermKind::Float && ei_decode_double(bytes_, &index, &out) == 0;
}

bool EiReader::read_atom(Term term, std::string_view &out) {
    int index = static_cast<int>(term);
    if (kind(term) != TermKind::Atom || ei_decode_atom_as(bytes_, &index, atom_, sizeof atom_,
                                                          ERLANG_UTF8, nullptr, nullptr) != 0) {
        return false;
    }
    out = atom_;
    return true;
}

bool EiReader::is_atom(Term term, const Name &name) {
    const std::string &text = name.text();
    if (is_byte(term)) {
        return false;
    }
    // The form that current virtual machines send, without a copy.
    if (byte_at(term) == ERL_SMALL_ATOM_UTF8_EXT) {
        return byte_at(term + 1) == text.size() &&
               std::memcmp(bytes_ + term + 2, text.data(), text.size()) == 0;
    }
    std::string_view own;
    return read_atom(term, own) && own == text;
}

bool EiReader::read_binary(Term term, std::string_view &out) {
    if (is_byte(term) || byte_at(term) != ERL_BINARY_EXT) {
        return false;
    }
    const std::size_t start = term + 5;
    out = {bytes_ + start, end_of(term) - start};
    return true;
}

bool EiReader::read_tuple(Term term, Term *out, unsigned max, unsigned &count) {
    int index = static_cast<int>(term);
    int arity = 0;
    if (kind(term) != TermKind::Tuple || ei_decode_tuple_header(bytes_, &index, &arity) != 0 ||
        static_cast<unsigned>(arity) > max) {
        return false;
    }
    count = static_cast<unsigned>(arity);
    Term at = static_cast<Term>(index);
    for (unsigned i = 0; i < count; ++i) {
        out[i] = at;
        at = i + 1 < count ? end_of(at) : at;
    }
    return true;
}

bool EiReader::read_list(Term term, ListCursor &out) {
    if (is_byte(term)) {
        return false;
    }
    switch (byte_at(term)) {
    case ERL_NIL_EXT:
        out = ListCursor{term, 0};
        return true;
    case ERL_STRING_EXT:
        out = ListCursor{(term + 3) | kByte,
                         static_cast<std::uint32_t>(byte_at(term + 1) << 8 | byte_at(term + 2))};
        return true;
    case ERL_LIST_EXT: {
        int index = static_cast<int>(term);
        int arity = 0;
        ei_decode_list_header(bytes_, &index, &arity);
        // The tail of a proper list is the empty list, in the last byte.
        const std::size_t tail = end_of(term) - 1;
        ListCursor cursor{static_cast<Term>(index), static_cast<std::uint32_t>(arity)};
        const ListCursor start = cursor;
        while (cursor.left > 0) {
            next(cursor);
        }
        if (cursor.at != tail || byte_at(tail) != ERL_NIL_EXT) {
            return false;
        }
        out = start;
        return true;
    }
    default:
        return false;
    }
}

Term EiReader::next(ListCursor &cursor) {
    const Term element = cursor.at;
    cursor.at = is_byte(element) ? element + 1 : end_of(element);
    --cursor.left;
    return element;
}

bool EiReader::read_map(Term term, MapEntries &out) {
    int index = static_cast<int>(term);
    int pairs = 0;
    if (kind(term) != TermKind::Map || ei_decode_map_header(bytes_, &index, &pairs) != 0) {
        return false;
    }
    Term at = static_cast<Term>(index);
    for (; pairs > 0; --pairs) {
        const Term value = end_of(at);
        out.emplace_back(at, value);
        at = end_of(value);
    }
    return true;
}

std::string_view EiReader::raw(Term term) const {
    return is_byte(term) ? std::string_view{}
                         : std::string_view{bytes_ + term, end_of(term) - term};
}

namespace {

constexpr char kNoLength[4] = {0, 0, 0, 0};

void check(int status) {
    if (status != 0) {
        throw std::bad_alloc(); // the only way in which these functions fail
    }
}

} // namespace

EiWriter::EiWriter() {
    check(ei_x_new(&buffer_));
    begin();
}

EiWriter::~EiWriter() {
    ei_x_free(&buffer_);
}

void EiWriter::begin() {
    buffer_.index = 0;
    open_lists_.clear();
    check(ei_x_append_buf(&buffer_, kNoLength, sizeof kNoLength));
    check(ei_x_encode_version(&buffer_));
}

std::string_view EiWriter::packet() {
    const auto length = static_cast<std::uint32_t>(buffer_.index) - 4;
    for (unsigned i = 0; i < 4; ++i) {
        buffer_.buff[i] = static_cast<char>(length >> (24 - 8 * i) & 0xFFU);
    }
    return {buffer_.buff, static_cast<std::size_t>(buffer_.index)};
}

void EiWriter::write_signed(std::int64_t value) {
    check(ei_x_encode_longlong(&buffer_, value));
}

void EiWriter::write_unsigned(std::uint64_t value) {
    check(ei_x_encode_ulonglong(&buffer_, value));
}

void EiWriter::write_float(double value) {
    check(ei_x_encode_double(&buffer_, value));
}

void EiWriter::write_atom(std::string_view text) {
    check(ei_x_encode_atom_len(&buffer_, text.data(), static_cast<int>(text.size())));
}

void EiWriter::write_name(const Name &name) {
    if (name.text().size() > 255) {
        return write_binary(name.text());
    }
    write_atom(name.text());
}

void EiWriter::write_binary(std::string_view bytes) {
    check(ei_x_encode_binary(&buffer_, bytes.data(), static_cast<int>(bytes.size())));
}

void EiWriter::begin_tuple(unsigned count) {
    open_lists_.push_back(false);
    check(ei_x_encode_tuple_header(&buffer_, count));
}

void EiWriter::begin_list(unsigned count) {
    open_lists_.push_back(true);
    if (count > 0) { // end() writes the empty list
        check(ei_x_encode_list_header(&buffer_, count));
    }
}

void EiWriter::begin_map(unsigned count) {
    open_lists_.push_back(false);
    check(ei_x_encode_map_header(&buffer_, static_cast<int>(count)));
}

void EiWriter::end() {
    if (open_lists_.back()) {
        check(ei_x_encode_empty_list(&buffer_));
    }
    open_lists_.pop_back();
}

void EiWriter::write_term(TermReader &reader, Term term) {
    if (EiReader::is_byte(term)) {
        std::int64_t value = 0;
        reader.read_signed(term, value);
        return write_signed(value);
    }
    const std::string_view bytes = static_cast<EiReader &>(reader).raw(term);
    check(ei_x_append_buf(&buffer_, bytes.data(), static_cast<int>(bytes.size())));
}

std::size_t EiWriter::mark() {
    return static_cast<std::size_t>(buffer_.index);
}

std::string EiWriter::written(std::size_t from, std::size_t to) {
    return {buffer_.buff + from, to - from};
}

void EiWriter::write_again(const std::string &terms) {
    check(ei_x_append_buf(&buffer_, terms.data(), static_cast<int>(terms.size())));
}

} // namespace cb
