#include "text_terms.hpp"

#include <cctype>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>

namespace cb {

namespace {

const TextTerm &at(Term term) {
    return *reinterpret_cast<const TextTerm *>(term);
}

Term as_term(const TextTerm *term) {
    return reinterpret_cast<Term>(term);
}

bool plain_atom(std::string_view text) {
    if (text.empty() || std::islower(static_cast<unsigned char>(text[0])) == 0) {
        return false;
    }
    for (const char c : text) {
        if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '@') {
            return false;
        }
    }
    return true;
}

} // namespace

Term TextReader::parse(const std::string &text) {
    source_ = text;
    at_ = 0;
    const TextTerm *parsed = term();
    skip_blanks();
    if (at_ != source_.size()) {
        std::fprintf(stderr, "not a term: %s\n", text.c_str());
        std::abort();
    }
    return as_term(parsed);
}

TextTerm &TextReader::make(TermKind kind) {
    terms_.emplace_back();
    terms_.back().kind = kind;
    return terms_.back();
}

void TextReader::skip_blanks() {
    while (at_ < source_.size() && source_[at_] == ' ') {
        ++at_;
    }
}

std::string TextReader::quoted(char end) {
    std::string text;
    for (++at_; source_.at(at_) != end; ++at_) {
        text.push_back(source_[at_]);
    }
    ++at_;
    return text;
}

void TextReader::elements(TextTerm &into, char close) {
    for (;;) {
        skip_blanks();
        if (source_.at(at_) == close) {
            ++at_;
            return;
        }
        if (source_[at_] == ',') {
            ++at_;
        } else if (source_[at_] == '|') {
            into.proper = false;
            ++at_;
        } else if (source_.compare(at_, 2, "=>") == 0) {
            at_ += 2;
        }
        into.elements.push_back(term());
    }
}

const TextTerm *TextReader::number() {
    char *end = nullptr;
    const char *start = source_.c_str() + at_;
    const bool negative = *start == '-';
    const std::size_t length = source_.find_first_not_of("0123456789.e+-", at_) - at_;
    const std::string text = source_.substr(at_, length);
    if (text.find('.') != std::string::npos) {
        TextTerm &made = make(TermKind::Float);
        made.number = std::strtod(start, &end);
        at_ += static_cast<std::size_t>(end - start);
        return &made;
    }
    TextTerm &made = make(TermKind::Integer);
    errno = 0;
    made.magnitude = std::strtoull(start + negative, &end, 10);
    made.wide = errno == ERANGE;
    made.negative = negative;
    made.text.assign(start, static_cast<std::size_t>(end - start));
    at_ += static_cast<std::size_t>(end - start);
    return &made;
}

const TextTerm *TextReader::term() {
    skip_blanks();
    const char c = source_.at(at_);
    if (c == '{' || c == '[') {
        TextTerm &made = make(c == '{' ? TermKind::Tuple : TermKind::List);
        ++at_;
        elements(made, c == '{' ? '}' : ']');
        return &made;
    }
    if (c == '#') {
        TextTerm &made = make(TermKind::Map);
        at_ += 2;
        elements(made, '}');
        return &made;
    }
    if (source_.compare(at_, 3, "<<\"") == 0) {
        TextTerm &made = make(TermKind::Binary);
        at_ += 2;
        made.text = quoted('"');
        at_ += 2;
        return &made;
    }
    if (c == '-' || std::isdigit(static_cast<unsigned char>(c)) != 0) {
        return number();
    }
    TextTerm &made = make(TermKind::Atom);
    if (c == '\'') {
        made.text = quoted('\'');
    } else {
        const std::size_t end = source_.find_first_of(" ,}]|=>", at_);
        made.text = source_.substr(at_, end - at_);
        at_ = std::min(end, source_.size());
    }
    return &made;
}

TermKind TextReader::kind(Term term) {
    return at(term).kind;
}

bool TextReader::read_signed(Term term, std::int64_t &out) {
    const TextTerm &t = at(term);
    const std::uint64_t limit = INT64_MAX + static_cast<std::uint64_t>(t.negative);
    if (t.kind != TermKind::Integer || t.wide || t.magnitude > limit) {
        return false;
    }
    out = static_cast<std::int64_t>(t.negative ? 0 - t.magnitude : t.magnitude);
    return true;
}

bool TextReader::read_unsigned(Term term, std::uint64_t &out) {
    const TextTerm &t = at(term);
    if (t.kind != TermKind::Integer || t.wide || t.negative) {
        return false;
    }
    out = t.magnitude;
    return true;
}

bool TextReader::read_float(Term term, double &out) {
    if (at(term).kind != TermKind::Float) {
        return false;
    }
    out = at(term).number;
    return true;
}

bool TextReader::read_atom(Term term, std::string_view &out) {
    if (at(term).kind != TermKind::Atom) {
        return false;
    }
    out = at(term).text;
    return true;
}

bool TextReader::is_atom(Term term, const Name &name) {
    return at(term).kind == TermKind::Atom && at(term).text == name.text();
}

bool TextReader::read_binary(Term term, std::string_view &out) {
    if (at(term).kind != TermKind::Binary) {
        return false;
    }
    out = at(term).text;
    return true;
}

bool TextReader::read_tuple(Term term, Term *out, unsigned max, unsigned &count) {
    const TextTerm &t = at(term);
    if (t.kind != TermKind::Tuple || t.elements.size() > max) {
        return false;
    }
    count = 0;
    for (const TextTerm *element : t.elements) {
        out[count++] = as_term(element);
    }
    return true;
}

// The cursor's place is that of the pointer to the next element.
bool TextReader::read_list(Term term, ListCursor &out) {
    const TextTerm &t = at(term);
    if (t.kind != TermKind::List || !t.proper) {
        return false;
    }
    out = ListCursor{reinterpret_cast<Term>(t.elements.data()),
                     static_cast<std::uint32_t>(t.elements.size())};
    return true;
}

Term TextReader::next(ListCursor &cursor) {
    const auto *place = reinterpret_cast<const TextTerm *const *>(cursor.at);
    cursor.at = reinterpret_cast<Term>(place + 1);
    --cursor.left;
    return as_term(*place);
}

bool TextReader::read_map(Term term, MapEntries &out) {
    const TextTerm &t = at(term);
    if (t.kind != TermKind::Map) {
        return false;
    }
    for (std::size_t i = 0; i + 1 < t.elements.size(); i += 2) {
        out.emplace_back(as_term(t.elements[i]), as_term(t.elements[i + 1]));
    }
    return true;
}

void TextWriter::put(const std::string &text) {
    const bool in_map = !open_.empty() && open_.back() == '}' && places_.back() != UINT32_MAX;
    if (comma_) {
        text_ += in_map && places_.back() % 2 == 1 ? "=>" : ",";
    }
    if (in_map) {
        ++places_.back();
    }
    text_ += text;
    comma_ = true;
}

void TextWriter::write_signed(std::int64_t value) {
    put(std::to_string(value));
}

void TextWriter::write_unsigned(std::uint64_t value) {
    put(std::to_string(value));
}

void TextWriter::write_float(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.10g", value);
    const std::string shown = text;
    put(shown.find_first_of(".e") == std::string::npos ? shown + ".0" : shown);
}

void TextWriter::write_atom(std::string_view text) {
    put(plain_atom(text) ? std::string(text) : "'" + std::string(text) + "'");
}

void TextWriter::write_name(const Name &name) {
    write_atom(name.text());
}

void TextWriter::write_binary(std::string_view bytes) {
    put("<<\"" + std::string(bytes) + "\">>");
}

void TextWriter::begin_tuple(unsigned) {
    put("{");
    open_.push_back('}');
    places_.push_back(UINT32_MAX);
    comma_ = false;
}

void TextWriter::begin_list(unsigned) {
    put("[");
    open_.push_back(']');
    places_.push_back(UINT32_MAX);
    comma_ = false;
}

void TextWriter::begin_map(unsigned) {
    put("#{");
    open_.push_back('}');
    places_.push_back(0);
    comma_ = false;
}

void TextWriter::end() {
    text_ += open_.back();
    open_.pop_back();
    places_.pop_back();
    comma_ = true;
}

void TextWriter::write_term(TermReader &reader, Term term) {
    const TextTerm &t = at(term);
    switch (t.kind) {
    case TermKind::Integer:
        return put(t.text);
    case TermKind::Float:
        return write_float(t.number);
    case TermKind::Atom:
        return write_atom(t.text);
    case TermKind::Binary:
        return write_binary(t.text);
    case TermKind::Tuple:
        begin_tuple(0);
        break;
    case TermKind::Map:
        begin_map(0);
        break;
    default:
        begin_list(0);
    }
    for (const TextTerm *element : t.elements) {
        write_term(reader, as_term(element));
    }
    end();
}

std::size_t TextWriter::mark() {
    return text_.size();
}

std::string TextWriter::written(std::size_t from, std::size_t to) {
    const std::string terms = text_.substr(from, to - from);
    return !terms.empty() && terms[0] == ',' ? terms.substr(1) : terms;
}

void TextWriter::write_again(const std::string &terms) {
    if (!terms.empty()) {
        put(terms);
    }
}

} // namespace cb
