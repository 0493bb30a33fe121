// Taking a packet, for one receiver.
#pragma once

#include "channel.h"

#include <cstring>

namespace fc {

inline void deliver(const std::string &packet, const GetCall &call) {
    if (!packet.empty())
        std::memcpy(call.data, packet.data(), packet.size());
    if (call.len != nullptr)
        *call.len = packet.size();
}

// FC_E_SPACE, with the length needed.
int need_space(const Channel &channel, std::size_t needed, const GetCall &call);

// Result as fc_channel_get. On an error the channel is as before.
int get_through_faults(Channel &channel, const GetCall &call);

} // namespace fc
