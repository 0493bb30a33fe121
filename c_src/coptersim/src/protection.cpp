#include "protection.h"

#include "Crc.h"
#include "E2E_P04.h"

namespace coptersim {

namespace {

constexpr uint16 kPacketBytes = CSIM_MESSAGE_BYTES + 12;
constexpr std::size_t kCrcBytes = 4;
constexpr uint16 kMaxDelta = 15; // messages missing in a row that are no error

std::uint32_t crc_of(const std::uint8_t *packet) {
    return Crc_CalculateCRC32P4(packet, CSIM_MESSAGE_BYTES, 0, 1);
}

E2E_P04ConfigType link_of(std::int32_t sender) {
    return {static_cast<uint32>(sender), 8 * CSIM_MESSAGE_BYTES, 8 * kPacketBytes, 8 * kPacketBytes,
            kMaxDelta};
}

bool accept_crc(const std::uint8_t *packet) {
    std::uint32_t sent = 0;
    for (std::size_t i = 0; i < kCrcBytes; ++i)
        sent |= static_cast<std::uint32_t>(packet[CSIM_MESSAGE_BYTES + i]) << (8 * i);
    return sent == crc_of(packet);
}

// Profile 4: header behind the data, Data ID the sender's id.
bool accept_e2e(const std::uint8_t *packet, LinkState *link) {
    const E2E_P04ConfigType config = link_of(unpack(packet).id);
    E2E_P04CheckStateType state{E2E_P04STATUS_ERROR, link->counter};
    if (E2E_P04Check(&config, &state, packet, kPacketBytes) != E2E_E_OK ||
        state.Status == E2E_P04STATUS_ERROR)
        return false;
    const bool first = !link->known;
    link->known = true;
    link->counter = state.Counter;
    return first || state.Status == E2E_P04STATUS_OK || state.Status == E2E_P04STATUS_OKSOMELOST;
}

} // namespace

std::size_t packet_size(Protect protect) {
    return CSIM_MESSAGE_BYTES + (protect == kProtectCrc   ? kCrcBytes
                                 : protect == kProtectE2E ? kPacketBytes - CSIM_MESSAGE_BYTES
                                                          : 0);
}

void protect_packet(Protect protect, std::int32_t sender, std::uint64_t counter,
                    std::uint8_t *packet) {
    if (protect == kProtectCrc) {
        const std::uint32_t crc = crc_of(packet);
        for (std::size_t i = 0; i < kCrcBytes; ++i)
            packet[CSIM_MESSAGE_BYTES + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    } else if (protect == kProtectE2E) {
        const E2E_P04ConfigType config = link_of(sender);
        E2E_P04ProtectStateType state{static_cast<uint16>(counter)};
        E2E_P04Protect(&config, &state, packet, kPacketBytes);
    }
}

bool accept_packet(Protect protect, const std::uint8_t *packet, LinkState *link) {
    switch (protect) {
    case kProtectCrc:
        return accept_crc(packet);
    case kProtectE2E:
        return accept_e2e(packet, link);
    default:
        return true;
    }
}

} // namespace coptersim
