// Queueing a packet.
#pragma once

#include "channel.h"

namespace fc {

// For every receiver, hidden for that many of his gets and until that time. Fails without a change.
int put_directly(Channel &channel, const PutCall &call, std::uint64_t gets, std::int64_t until_ns);

// FC_OK or FC_E_BLOCKED. Fails without a change.
int put_through_faults(Channel &channel, const PutCall &call);

// Why a fault left a packet of that size as it was.
Text why_skipped(const Channel &channel, const ChannelFault &fault, int code, std::size_t size);

} // namespace fc
