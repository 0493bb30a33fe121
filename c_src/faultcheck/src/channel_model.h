// What a fault on a channel does, and its parameters.
#pragma once

#include "fc_channel.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fc {

enum class ChannelModelKind : std::uint8_t {
    // met at a get
    corruption, // byte `index`, bit `bit`
    field,      // model on field
    truncate,   // to `index` bytes
    extend,     // by `index` bytes of value `bit`
    drop,       // budget
    repeat,     // budget
    lose,
    repeat_last,
    insert,     // text, budget
    masquerade, // from channel `text`
    resequence, // position `index`
    block_get,
    // met at a put
    delay_gets, // `index` gets
    delay_time, // `index` nanoseconds
    misroute,   // to channel `text`
    asymmetric, // receivers, field, model
    subset,     // receivers
    block_put,
};

struct ChannelModel {
    ChannelModelKind kind = ChannelModelKind::corruption;
    std::int64_t index = 0;
    std::int64_t bit = 0;
    std::uint64_t budget = 0;
    std::string text;
    std::vector<std::string> receivers;
    fc_field field{0, FC_BYTES, false, 0};
    fc_model model{FC_SET_TO, 0, 0, 0};

    bool met_at_put() const {
        return kind >= ChannelModelKind::delay_gets;
    }
};

} // namespace fc
