// One request of the vector runner: reading its members, with an error that names what is wrong.
#ifndef E2E_VECTORS_REQUEST_HPP
#define E2E_VECTORS_REQUEST_HPP

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace e2e_vectors {

using json = nlohmann::json;
using Bytes = std::vector<std::uint8_t>;

// The line cannot be used; what() says why.
struct BadRequest : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The runner does not know this op, profile or checksum.
struct Unsupported {};

Bytes from_hex(const std::string &text, const char *name);
std::string to_hex(const Bytes &bytes);
std::string to_hex(std::uint64_t value, int digits);

// A string member that must be there.
std::string text(const json &object, const char *name);

// An object member; an absent one is an empty object.
const json &object(const json &request, const char *name);

// Is `name` in the request's list of arguments to pass as NULL?
bool is_null(const json &request, const char *name);

// An integer or boolean in [0, max].
std::uint64_t number(const json &value, const char *name, std::uint64_t max);

// Reads an integer, boolean or enumeration member; an absent one is 0.
template <class T> void read(const json &from, const char *name, T &out) {
    const auto found = from.find(name);
    if (found == from.end()) {
        out = T{};
    } else if constexpr (std::is_enum_v<T>) {
        out = static_cast<T>(number(*found, name, 255));
    } else {
        out = static_cast<T>(number(*found, name, std::numeric_limits<T>::max()));
    }
}

} // namespace e2e_vectors

#endif
