#include "message.h"

#include <cstring>

namespace coptersim {

namespace {

// Little-endian whatever the machine is.
void write(std::uint8_t *to, std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i)
        to[i] = static_cast<std::uint8_t>(value >> (8 * i));
}

std::uint64_t read(const std::uint8_t *from, int size) {
    std::uint64_t value = 0;
    for (int i = 0; i < size; ++i)
        value |= static_cast<std::uint64_t>(from[i]) << (8 * i);
    return value;
}

void write_real(std::uint8_t *to, double value) {
    std::uint64_t word;
    std::memcpy(&word, &value, sizeof word);
    write(to, word, 8);
}

double read_real(const std::uint8_t *from) {
    const std::uint64_t word = read(from, 8);
    double value;
    std::memcpy(&value, &word, sizeof value);
    return value;
}

// The members of the state in the order of the layout, from byte 12 on.
constexpr double csim_state::*kOrder[] = {
    &csim_state::px,  &csim_state::py,  &csim_state::pz,   &csim_state::vx,    &csim_state::vy,
    &csim_state::e_r, &csim_state::e_p, &csim_state::roll, &csim_state::pitch, &csim_state::yaw};

} // namespace

void pack(const csim_message &message, std::uint8_t *bytes) {
    write(bytes, static_cast<std::uint32_t>(message.id), 4);
    write(bytes + 4, message.stamp_us, 8);
    std::uint8_t *at = bytes + 12;
    for (auto member : kOrder) {
        write_real(at, message.state.*member);
        at += 8;
    }
}

csim_message unpack(const std::uint8_t *bytes) {
    csim_message message;
    const auto id = static_cast<std::uint32_t>(read(bytes, 4));
    std::memcpy(&message.id, &id, sizeof id);
    message.stamp_us = read(bytes + 4, 8);
    const std::uint8_t *at = bytes + 12;
    for (auto member : kOrder) {
        message.state.*member = read_real(at);
        at += 8;
    }
    return message;
}

} // namespace coptersim
