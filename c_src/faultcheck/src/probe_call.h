// The way of a probe call: an idle identifier costs a table lookup and one load.
#pragma once

#include "context.h"

#include <cstdint>

namespace fc {

// The first call of an identifier with a type. known: its record, or null when it has none yet.
template <class T> int probe_unseen(fc_context &context, Probe *known, const char *id, T *value);

// The record of an identifier that is monitored, listed from now on.
Probe &monitored(fc_context &context, const char *id, fc_type type);

// A call on an identifier that has faults or is watched.
template <class T> int probe_armed(fc_context &context, Probe &probe, T *value);

// The call once the record is known.
template <class T> inline int probe_record(fc_context &context, Probe &probe, T *value) {
    const std::uint8_t state = probe.state[TypeOf<T>::value].load(std::memory_order_relaxed);
    if (state == 0)
        return FC_OK;
    if ((state & Probe::kUnseen) != 0)
        return probe_unseen(context, &probe, probe.name.text().c_str(), value);
    return probe_armed(context, probe, value);
}

template <class T> inline int probe_by_name(fc_context *ctx, const char *id, T *value) {
    fc_context &context = context_of(ctx);
    const Name name = read_name(id);
    Probe *probe = context.probes.find(name);
    if (probe == nullptr)
        return probe_unseen(context, probe, id, value);
    return probe_record(context, *probe, value);
}

} // namespace fc
