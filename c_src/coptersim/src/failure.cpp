#include "failure.h"

#include <cstdarg>
#include <cstdio>

namespace coptersim {

namespace {

thread_local char text[256];

} // namespace

int fail(int code, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    return code;
}

const char *last_failure() {
    return text;
}

} // namespace coptersim
