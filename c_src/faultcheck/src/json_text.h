// Pieces of JSON text.
#pragma once

#include <string>

namespace fc {

// In quotes. Bytes that are not printable ASCII are written as \u00XX, so identifiers of any bytes
// come through.
std::string json_string(const std::string &bytes);
// C99 hexadecimal, in quotes: exact to the bit.
std::string json_float(double value);
// Two digits a byte, in quotes.
std::string json_hex(const char *bytes, std::size_t size);

} // namespace fc
