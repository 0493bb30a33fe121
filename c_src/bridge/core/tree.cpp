#include "tree.hpp"

namespace cb {

Tree Tree::atom(std::string text) {
    Tree tree;
    tree.shape_ = text.size() > 255 ? Shape::Binary : Shape::Atom;
    tree.text_ = std::move(text);
    return tree;
}

Tree Tree::binary(std::string bytes) {
    Tree tree;
    tree.shape_ = Shape::Binary;
    tree.text_ = std::move(bytes);
    return tree;
}

Tree Tree::integer(std::int64_t value) {
    Tree tree;
    tree.shape_ = Shape::Integer;
    tree.integer_ = value;
    return tree;
}

Tree Tree::tuple(std::vector<Tree> elements) {
    Tree tree;
    tree.shape_ = Shape::Tuple;
    tree.elements_ = std::move(elements);
    return tree;
}

Tree Tree::list(std::vector<Tree> elements) {
    Tree tree = tuple(std::move(elements));
    tree.shape_ = Shape::List;
    return tree;
}

Tree Tree::map(std::vector<Tree> keys_and_values) {
    Tree tree = tuple(std::move(keys_and_values));
    tree.shape_ = Shape::Map;
    return tree;
}

Tree Tree::foreign(TermReader &reader, Term term) {
    Tree tree;
    tree.shape_ = Shape::Foreign;
    tree.reader_ = &reader;
    tree.term_ = term;
    return tree;
}

Tree Tree::written_list(std::string terms, unsigned count) {
    Tree tree = integer(count);
    tree.shape_ = Shape::WrittenList;
    tree.text_ = std::move(terms);
    return tree;
}

void Tree::write(TermWriter &writer) const {
    const auto count = static_cast<unsigned>(elements_.size());
    switch (shape_) {
    case Shape::Atom:
        return writer.write_atom(text_);
    case Shape::Binary:
        return writer.write_binary(text_);
    case Shape::Integer:
        return writer.write_signed(integer_);
    case Shape::Foreign:
        return writer.write_term(*reader_, term_);
    case Shape::WrittenList:
        writer.begin_list(static_cast<unsigned>(integer_));
        writer.write_again(text_);
        return writer.end();
    case Shape::Tuple:
        writer.begin_tuple(count);
        break;
    case Shape::List:
        writer.begin_list(count);
        break;
    case Shape::Map:
        writer.begin_map(count / 2);
        break;
    }
    for (const Tree &element : elements_) {
        element.write(writer);
    }
    writer.end();
}

Tree Tree::owned() const {
    Tree copy = *this;
    if (shape_ == Shape::Foreign) {
        std::int64_t number = 0;
        std::string name;
        if (reader_->read_signed(term_, number)) {
            return integer(number);
        }
        return read_text(*reader_, term_, name) ? atom(name) : atom("_");
    }
    for (Tree &element : copy.elements_) {
        element = element.owned();
    }
    return copy;
}

std::string Tree::text() const {
    switch (shape_) {
    case Shape::Atom:
        return text_;
    case Shape::Binary:
        return "<<\"" + text_ + "\">>";
    case Shape::Integer:
        return std::to_string(integer_);
    case Shape::Foreign:
    case Shape::WrittenList:
        return "_";
    default:
        break;
    }
    std::string inside;
    for (const Tree &element : elements_) {
        inside += (inside.empty() ? "" : ",") + element.text();
    }
    return shape_ == Shape::Tuple  ? "{" + inside + "}"
           : shape_ == Shape::List ? "[" + inside + "]"
                                   : "#{" + inside + "}";
}

} // namespace cb
