/* members.cpp: checked access to the members of an object. */
#include "members.hpp"

#include <cmath>

namespace csim_scenario {
namespace {

[[noreturn]] void wrong_kind(const node &value, const std::string &where, const char *expected) {
    throw located_error(value.line,
                        where + ": " + expected + " expected, not " + kind_name(value.kind));
}

std::string range(std::uint64_t least, std::uint64_t most) {
    return "from " + std::to_string(least) + " to " + std::to_string(most);
}

} // namespace

double as_number(const node &value, const std::string &where) {
    if (value.kind != node::number) {
        wrong_kind(value, where, "a number");
    }
    return value.real;
}

std::uint64_t as_whole(const node &value, const std::string &where, std::uint64_t least,
                       std::uint64_t most) {
    if (value.kind != node::number) {
        wrong_kind(value, where, "a whole number");
    }
    std::uint64_t integer = value.integer;
    bool whole = value.whole;
    if (!whole && value.real >= 0 && value.real <= static_cast<double>(largest_whole) &&
        value.real == std::floor(value.real)) {
        integer = static_cast<std::uint64_t>(value.real);
        whole = true;
    }
    if (!whole || integer < least || integer > most) {
        throw located_error(value.line,
                            where + ": a whole number " + range(least, most) + " expected");
    }
    return integer;
}

const std::string &as_text(const node &value, std::string_view where) {
    if (value.kind != node::text) {
        wrong_kind(value, std::string(where), "a text");
    }
    if (value.characters.find('\0') != std::string::npos) {
        throw located_error(value.line,
                            std::string(where) + ": a text without the character 0 expected");
    }
    return value.characters;
}

bool as_truth(const node &value, const std::string &where) {
    if (value.kind != node::boolean) {
        wrong_kind(value, where, "true or false");
    }
    return value.truth;
}

std::vector<double> as_numbers(const node &value, const std::string &where, std::size_t count) {
    std::string expected = "an array of " + std::to_string(count) + " numbers";
    if (value.kind != node::array) {
        wrong_kind(value, where, expected.c_str());
    }
    if (value.items.size() != count) {
        throw located_error(value.line, where + ": " + expected + " expected, not of " +
                                            std::to_string(value.items.size()));
    }
    std::vector<double> numbers;
    for (const node &item : value.items) {
        numbers.push_back(as_number(item, where));
    }
    return numbers;
}

const std::vector<node> &as_array(const node &value, std::string_view where, std::size_t most) {
    if (value.kind != node::array) {
        wrong_kind(value, std::string(where), "an array");
    }
    if (value.items.size() > most) {
        throw located_error(value.line, std::string(where) + ": " +
                                            std::to_string(value.items.size()) +
                                            " items, at most " + std::to_string(most));
    }
    return value.items;
}

members::members(const node &object, std::string where)
    : object_(object), where_(std::move(where)), asked_(object.items.size()) {
    if (object.kind != node::object) {
        wrong_kind(object, where_.empty() ? "scenario" : where_, "an object");
    }
}

std::string members::path(const std::string &name) const {
    return where_.empty() ? name : where_ + "." + name;
}

const node *members::find(const char *name) {
    known_ += (known_.empty() ? "" : ", ") + std::string(name);
    for (std::size_t i = 0; i < object_.keys.size(); i++) {
        if (object_.keys[i] == name) {
            asked_[i] = true;
            return &object_.items[i];
        }
    }
    return nullptr;
}

const node &members::need(const char *name) {
    const node *value = find(name);
    if (value == nullptr) {
        throw located_error(object_.line, path(name) + " is missing");
    }
    return *value;
}

double members::number(const char *name, double otherwise) {
    const node *value = find(name);
    return value == nullptr ? otherwise : as_number(*value, path(name));
}

std::uint64_t members::whole(const char *name, std::uint64_t least, std::uint64_t most) {
    return as_whole(need(name), path(name), least, most);
}

std::uint64_t members::whole(const char *name, std::uint64_t least, std::uint64_t most,
                             std::uint64_t otherwise) {
    const node *value = find(name);
    return value == nullptr ? otherwise : as_whole(*value, path(name), least, most);
}

std::int32_t members::id(const char *name) {
    return static_cast<std::int32_t>(whole(name, 0, INT32_MAX));
}

std::string members::text(const char *name) {
    return as_text(need(name), path(name));
}

std::string members::text(const char *name, const std::string &otherwise) {
    const node *value = find(name);
    return value == nullptr ? otherwise : as_text(*value, path(name));
}

std::vector<std::size_t> members::others() const {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < object_.keys.size(); i++) {
        const std::string &name = object_.keys[i];
        bool comment = name == "class" || name == "description" || name.compare(0, 2, "x_") == 0;
        if (!asked_[i] && !comment) {
            result.push_back(i);
        }
    }
    return result;
}

void members::finish() const {
    for (std::size_t i : others()) {
        throw located_error(object_.items[i].line,
                            path(object_.keys[i]) + ": unknown; known here: " + known_);
    }
}

} // namespace csim_scenario
