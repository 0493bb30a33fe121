// Taking a packet: the get-stage faults of a channel, for one receiver.
#pragma once

#include "channel.h"

#include <cstring>

namespace fc {

inline void deliver(const std::string &packet, char *data, std::size_t *len) {
    std::memcpy(data, packet.data(), packet.size());
    if (len != nullptr)
        *len = packet.size();
}

// FC_E_SPACE, with the length needed.
int need_space(const Channel &channel, std::size_t needed, std::size_t capacity, std::size_t *len,
               Reports &reports);

// Result and parameters of fc_channel_get. On an error the channel is as before.
int get_through_faults(Channel &channel, std::size_t receiver, char *data, std::size_t capacity,
                       std::size_t *len, Reports &reports);

} // namespace fc
