/* located_json.cpp: the parser's events, with the line it has reached, as a tree. */
#include "located_json.hpp"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <unordered_set>

namespace csim_scenario {
namespace {

using json = nlohmann::json;

constexpr std::size_t max_depth = 32;

/* Reads characters and tells how far it has come. The parser copies it; all copies tell one. */
struct watched_iterator {
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char *;
    using reference = const char &;

    const char *at;
    const char **reached;

    reference operator*() const {
        return *at;
    }
    watched_iterator &operator++() {
        *reached = ++at;
        return *this;
    }
    watched_iterator operator++(int) {
        watched_iterator old = *this;
        ++*this;
        return old;
    }
    bool operator==(const watched_iterator &other) const {
        return at == other.at;
    }
    bool operator!=(const watched_iterator &other) const {
        return at != other.at;
    }
};

class tree_builder : public json::json_sax_t {
  public:
    explicit tree_builder(std::string_view text) : reached(text.data()), counted_(text.data()) {
        open_.reserve(max_depth);
    }

    bool null() override {
        return add(node{});
    }
    bool boolean(bool value) override {
        node n;
        n.kind = node::boolean;
        n.truth = value;
        return add(std::move(n));
    }
    bool number_integer(number_integer_t value) override {
        return add_number(static_cast<double>(value), false, 0);
    }
    bool number_unsigned(number_unsigned_t value) override {
        return add_number(static_cast<double>(value), true, value);
    }
    bool number_float(number_float_t value, const string_t &) override {
        return add_number(value, false, 0);
    }
    bool string(string_t &value) override {
        node n;
        n.kind = node::text;
        n.characters = std::move(value);
        return add(std::move(n));
    }
    bool binary(binary_t &) override {
        return false; /* JSON text has none */
    }
    bool start_object(std::size_t) override {
        return open(node::object);
    }
    bool start_array(std::size_t) override {
        return open(node::array);
    }
    bool key(string_t &value) override {
        node &object = *open_.back();
        if (!keys_.back().insert(value).second) {
            throw located_error(line(), "the member \"" + value + "\" is there twice");
        }
        object.keys.push_back(std::move(value));
        return true;
    }
    bool end_object() override {
        return close();
    }
    bool end_array() override {
        return close();
    }
    bool parse_error(std::size_t, const std::string &, const json::exception &e) override {
        throw located_error(line(), reason(e.what()));
    }

    node take() {
        return std::move(root_);
    }

    const char *reached; /* by the parser */

  private:
    /* Lines up to the last character but `back` that the parser has read. */
    int line(int back = 0) {
        for (; counted_ < reached - back; counted_++) {
            line_ += *counted_ == '\n';
        }
        return line_;
    }

    bool add_number(double real, bool whole, std::uint64_t integer) {
        node n;
        n.kind = node::number;
        n.real = real;
        n.whole = whole;
        n.integer = integer;
        return add(std::move(n), 1); /* the end of a number shows in the character behind it */
    }

    bool add(node n, int back = 0) {
        n.line = line(back);
        if (open_.empty()) {
            root_ = std::move(n);
        } else {
            open_.back()->items.push_back(std::move(n));
        }
        return true;
    }

    /* Pointers to open nodes stay valid: only the innermost open one gets more items. */
    bool open(node::kind_type kind) {
        if (open_.size() == max_depth) {
            throw located_error(line(), "nested deeper than 32 levels");
        }
        node n;
        n.kind = kind;
        add(std::move(n));
        open_.push_back(open_.empty() ? &root_ : &open_.back()->items.back());
        keys_.emplace_back();
        return true;
    }

    bool close() {
        open_.back()->items.shrink_to_fit();
        open_.pop_back();
        keys_.pop_back();
        return true;
    }

    /* nlohmann-json's text without its error number and position, which follow "parse error". */
    static std::string reason(const std::string &what) {
        std::size_t from = what.find(": ");
        std::string text = from == std::string::npos ? what : what.substr(from + 2);
        for (char &c : text) {
            c = static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
        }
        return "not JSON: " + text.substr(0, 300);
    }

    const char *counted_;
    int line_ = 1;
    node root_;
    std::vector<node *> open_;
    std::vector<std::unordered_set<std::string>> keys_;
};

} // namespace

const char *kind_name(node::kind_type kind) {
    static const char *const names[] = {"null",   "true or false", "a number",
                                        "a text", "an array",      "an object"};
    return names[kind];
}

node parse_located(std::string_view text) {
    tree_builder builder(text);
    watched_iterator begin{text.data(), &builder.reached};
    watched_iterator end{text.data() + text.size(), &builder.reached};
    json::sax_parse(begin, end, &builder);
    return builder.take();
}

} // namespace csim_scenario
