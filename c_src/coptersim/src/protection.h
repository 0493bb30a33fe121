// What guards the bytes of a message on their way: nothing, a checksum, or end-to-end protection.
// It follows the 92 bytes, whose layout it does not change.
#pragma once

#include "message.h"
#include "params.h"

#include <cstddef>
#include <cstdint>

namespace coptersim {

constexpr std::size_t kLongestPacket = CSIM_MESSAGE_BYTES + 12;

// Length of a packet.
std::size_t packet_size(Protect protect);

// Completes a packet whose first 92 bytes are there. counter: number of the broadcast.
void protect_packet(Protect protect, std::int32_t sender, std::uint64_t counter,
                    std::uint8_t *packet);

// The counter of the packet last accepted from a sender.
struct LinkState {
    std::uint16_t counter = 0;
    bool known = false; // false: any counter is right
};

// True when the receiver may use the packet; the sender is the one its bytes name.
bool accept_packet(Protect protect, const std::uint8_t *packet, LinkState *link);

} // namespace coptersim
