#include "nif_terms.hpp"

namespace cb {

TermKind NifReader::kind(Term term) {
    switch (enif_term_type(env_, term)) {
    case ERL_NIF_TERM_TYPE_INTEGER:
        return TermKind::Integer;
    case ERL_NIF_TERM_TYPE_FLOAT:
        return TermKind::Float;
    case ERL_NIF_TERM_TYPE_ATOM:
        return TermKind::Atom;
    case ERL_NIF_TERM_TYPE_BITSTRING:
        return TermKind::Binary;
    case ERL_NIF_TERM_TYPE_TUPLE:
        return TermKind::Tuple;
    case ERL_NIF_TERM_TYPE_LIST:
        return TermKind::List;
    case ERL_NIF_TERM_TYPE_MAP:
        return TermKind::Map;
    default:
        return TermKind::Other;
    }
}

bool NifReader::read_signed(Term term, std::int64_t &out) {
    ErlNifSInt64 value = 0;
    if (enif_get_int64(env_, term, &value) == 0) {
        return false;
    }
    out = value;
    return true;
}

bool NifReader::read_unsigned(Term term, std::uint64_t &out) {
    ErlNifUInt64 value = 0;
    if (enif_get_uint64(env_, term, &value) == 0) {
        return false;
    }
    out = value;
    return true;
}

bool NifReader::read_float(Term term, double &out) {
    return enif_get_double(env_, term, &out) != 0;
}

bool NifReader::read_atom(Term term, std::string_view &out) {
    const int size = enif_get_atom(env_, term, atom_, sizeof atom_, ERL_NIF_LATIN1);
    if (size <= 0) {
        return false;
    }
    out = {atom_, static_cast<std::size_t>(size) - 1};
    return true;
}

bool NifReader::is_atom(Term term, const Name &name) {
    // Longer texts are written as binaries, see Tree::atom().
    return name.text().size() <= 255 && atom_of(env_, name) == term;
}

bool NifReader::atom_key(Term term, std::uint64_t &out) {
    out = term;
    return enif_is_atom(env_, term) != 0;
}

bool NifReader::read_binary(Term term, std::string_view &out) {
    ErlNifBinary binary;
    if (enif_inspect_binary(env_, term, &binary) == 0) {
        return false;
    }
    out = {reinterpret_cast<const char *>(binary.data), binary.size};
    return true;
}

bool NifReader::read_tuple(Term term, Term *out, unsigned max, unsigned &count) {
    const ERL_NIF_TERM *elements = nullptr;
    int arity = 0;
    if (enif_get_tuple(env_, term, &arity, &elements) == 0 || static_cast<unsigned>(arity) > max) {
        return false;
    }
    for (int i = 0; i < arity; ++i) {
        out[i] = elements[i];
    }
    count = static_cast<unsigned>(arity);
    return true;
}

bool NifReader::read_list(Term term, ListCursor &out) {
    unsigned length = 0;
    if (enif_get_list_length(env_, term, &length) == 0) {
        return false;
    }
    out = ListCursor{term, length};
    return true;
}

Term NifReader::next(ListCursor &cursor) {
    ERL_NIF_TERM head = 0;
    ERL_NIF_TERM tail = 0;
    enif_get_list_cell(env_, cursor.at, &head, &tail);
    cursor.at = tail;
    --cursor.left;
    return head;
}

bool NifReader::read_map(Term term, MapEntries &out) {
    ErlNifMapIterator iterator;
    if (enif_map_iterator_create(env_, term, &iterator, ERL_NIF_MAP_ITERATOR_FIRST) == 0) {
        return false;
    }
    ERL_NIF_TERM key = 0;
    ERL_NIF_TERM value = 0;
    while (enif_map_iterator_get_pair(env_, &iterator, &key, &value) != 0) {
        out.emplace_back(key, value);
        enif_map_iterator_next(env_, &iterator);
    }
    enif_map_iterator_destroy(env_, &iterator);
    return true;
}

void NifWriter::write_signed(std::int64_t value) {
    terms_.push_back(enif_make_int64(env_, value));
}

void NifWriter::write_unsigned(std::uint64_t value) {
    terms_.push_back(enif_make_uint64(env_, value));
}

void NifWriter::write_float(double value) {
    terms_.push_back(enif_make_double(env_, value));
}

void NifWriter::write_atom(std::string_view text) {
    terms_.push_back(enif_make_atom_len(env_, text.data(), text.size()));
}

void NifWriter::write_name(const Name &name) {
    if (name.text().size() > 255) {
        return write_binary(name.text());
    }
    terms_.push_back(atom_of(env_, name));
}

void NifWriter::write_binary(std::string_view bytes) {
    ERL_NIF_TERM term = 0;
    unsigned char *place = enif_make_new_binary(env_, bytes.size(), &term);
    std::memcpy(place, bytes.data(), bytes.size());
    terms_.push_back(term);
}

void NifWriter::begin_tuple(unsigned) {
    open_.push_back(Open{Shape::Tuple, terms_.size()});
}

void NifWriter::begin_list(unsigned) {
    open_.push_back(Open{Shape::List, terms_.size()});
}

void NifWriter::begin_map(unsigned) {
    open_.push_back(Open{Shape::Map, terms_.size()});
}

void NifWriter::end() {
    const Open open = open_.back();
    open_.pop_back();
    const ERL_NIF_TERM *elements = terms_.data() + open.start;
    const auto count = static_cast<unsigned>(terms_.size() - open.start);
    ERL_NIF_TERM made = 0;
    switch (open.shape) {
    case Shape::Tuple:
        made = enif_make_tuple_from_array(env_, elements, count);
        break;
    case Shape::List:
        made = enif_make_list_from_array(env_, elements, count);
        break;
    case Shape::Map:
        made = make_map(elements, count / 2);
        break;
    }
    terms_.resize(open.start);
    terms_.push_back(made);
}

ERL_NIF_TERM NifWriter::make_map(const ERL_NIF_TERM *pairs, std::size_t count) {
    ERL_NIF_TERM map = 0;
    ERL_NIF_TERM keys[16];
    ERL_NIF_TERM values[16];
    if (count <= 16) {
        for (std::size_t i = 0; i < count; ++i) {
            keys[i] = pairs[2 * i];
            values[i] = pairs[2 * i + 1];
        }
        if (enif_make_map_from_arrays(env_, keys, values, count, &map) != 0) {
            return map;
        }
    }
    map = enif_make_new_map(env_);
    for (std::size_t i = 0; i < count; ++i) {
        enif_make_map_put(env_, map, pairs[2 * i], pairs[2 * i + 1], &map);
    }
    return map;
}

void NifWriter::write_term(TermReader &, Term term) {
    terms_.push_back(term);
}

std::size_t NifWriter::mark() {
    return terms_.size();
}

std::string NifWriter::written(std::size_t from, std::size_t to) {
    return {reinterpret_cast<const char *>(terms_.data() + from),
            (to - from) * sizeof(ERL_NIF_TERM)};
}

void NifWriter::write_again(const std::string &terms) {
    const std::size_t count = terms.size() / sizeof(ERL_NIF_TERM);
    terms_.resize(terms_.size() + count);
    std::memcpy(terms_.data() + terms_.size() - count, terms.data(), terms.size());
}

} // namespace cb
