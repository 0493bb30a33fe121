// What a message says, its 92 bytes, and what a receiver keeps of it.
#pragma once

#include "csim.h"

#include <cstdint>

namespace coptersim {

void pack(const csim_message &message, std::uint8_t *bytes);
csim_message unpack(const std::uint8_t *bytes);

// What receivers use of a message.
struct Heard {
    double px, py, vx, vy; // m, m/s
    std::uint64_t stamp;   // us, the sender's clock
};

struct Position {
    double x, y;
};

// Constant velocity since the time `from`, us.
inline Position extrapolate(const Heard &heard, std::uint64_t from, std::uint64_t now) {
    const double elapsed = static_cast<double>(now - from) * 1e-6;
    return {heard.px + heard.vx * elapsed, heard.py + heard.vy * elapsed};
}

inline bool has_expired(std::uint64_t stamp, std::uint64_t now, std::uint64_t expiry) {
    return (stamp > now ? stamp - now : now - stamp) > expiry;
}

// Age of a message in seconds; 0 for one from the future.
inline double age_of(std::uint64_t stamp, std::uint64_t now) {
    return stamp < now ? static_cast<double>(now - stamp) * 1e-6 : 0;
}

} // namespace coptersim
