// How a function of csim.h says what went wrong.
#pragma once

namespace coptersim {

// Remembers the text for csim_last_error_text and returns code.
int fail(int code, const char *format, ...) __attribute__((format(printf, 2, 3)));

const char *last_failure();

} // namespace coptersim
