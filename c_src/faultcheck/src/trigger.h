// When a fault is active: the iteration window.
#pragma once

#include <cstdint>

namespace fc {

struct Trigger {
    static constexpr std::int64_t kForever = -1;

    std::uint64_t countdown = 0;      // calls still to pass before the first affected one
    std::int64_t duration = kForever; // affected calls left; negative: no limit

    void after(std::uint64_t calls) {
        countdown = calls;
        duration = kForever;
    }
    void once_after(std::uint64_t calls) {
        countdown = calls;
        duration = 1;
    }

    // One call passes. True when the window is open for it.
    bool advance() {
        if (duration == 0)
            return false;
        if (countdown > 0) {
            --countdown;
            return false;
        }
        return true;
    }

    // The call was affected.
    void consume() {
        if (duration > 0)
            --duration;
    }
};

} // namespace fc
