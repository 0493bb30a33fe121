// Whether this process runs under AddressSanitizer, linked in or preloaded.
#pragma once

extern "C" __attribute__((weak)) void __asan_init();

namespace cb {

inline bool under_address_sanitizer() {
    return __asan_init != nullptr;
}

} // namespace cb
