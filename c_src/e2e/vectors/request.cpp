#include "request.hpp"

namespace e2e_vectors {

namespace {

int nibble(char digit, const char *name) {
    if (digit >= '0' && digit <= '9') {
        return digit - '0';
    }
    if (digit >= 'a' && digit <= 'f') {
        return digit - 'a' + 10;
    }
    throw BadRequest(std::string(name) + " holds a character that is not a lower-case hex digit");
}

} // namespace

Bytes from_hex(const std::string &text, const char *name) {
    if (text.size() % 2 != 0) {
        throw BadRequest(std::string(name) + " has an odd number of hex digits");
    }
    Bytes bytes(text.size() / 2);
    for (std::size_t i = 0; i < bytes.size(); i++) {
        bytes[i] = static_cast<std::uint8_t>(nibble(text[2 * i], name) * 16 +
                                             nibble(text[2 * i + 1], name));
    }
    return bytes;
}

std::string to_hex(std::uint64_t value, int digits) {
    std::string out(static_cast<std::size_t>(digits), '0');
    for (auto digit = out.rbegin(); digit != out.rend(); ++digit, value >>= 4) {
        *digit = "0123456789abcdef"[value & 15];
    }
    return out;
}

std::string to_hex(const Bytes &bytes) {
    std::string out;
    out.reserve(2 * bytes.size());
    for (const std::uint8_t byte : bytes) {
        out += to_hex(byte, 2);
    }
    return out;
}

std::string text(const json &object, const char *name) {
    const auto found = object.find(name);
    if (found == object.end() || !found->is_string()) {
        throw BadRequest(std::string("member ") + name + " must be a string");
    }
    return *found;
}

const json &object(const json &request, const char *name) {
    static const json empty = json::object();
    const auto found = request.find(name);
    if (found == request.end()) {
        return empty;
    }
    if (!found->is_object()) {
        throw BadRequest(std::string("member ") + name + " must be an object");
    }
    return *found;
}

bool is_null(const json &request, const char *name) {
    const auto list = request.find("null");
    if (list == request.end()) {
        return false;
    }
    if (!list->is_array()) {
        throw BadRequest("member null must be an array of argument names");
    }
    for (const json &entry : *list) {
        if (entry == name) {
            return true;
        }
    }
    return false;
}

std::uint64_t number(const json &value, const char *name, std::uint64_t max) {
    if (value.is_boolean()) {
        return value.get<bool>() ? 1 : 0;
    }
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() > max) {
        throw BadRequest(std::string("member ") + name + " must be an integer from 0 to " +
                         std::to_string(max));
    }
    return value.get<std::uint64_t>();
}

} // namespace e2e_vectors
