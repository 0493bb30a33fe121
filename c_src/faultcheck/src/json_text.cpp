#include "json_text.h"

#include <cstdio>

namespace fc {

std::string json_string(const std::string &bytes) {
    std::string text = "\"";
    for (const char byte : bytes) {
        const auto code = static_cast<unsigned char>(byte);
        char escaped[8];
        if (code < 0x20 || code >= 0x7f) {
            std::snprintf(escaped, sizeof escaped, "\\u%04x", code);
            text += escaped;
        } else {
            if (byte == '"' || byte == '\\')
                text += '\\';
            text += byte;
        }
    }
    return text + '"';
}

std::string json_float(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "\"%a\"", value);
    return text;
}

std::string json_hex(const char *bytes, std::size_t size) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text = "\"";
    for (std::size_t at = 0; at < size; ++at) {
        const auto byte = static_cast<unsigned char>(bytes[at]);
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text + '"';
}

} // namespace fc
