// The way of a probe call: an idle identifier costs a table lookup and one load.
#pragma once

#include "context.h"

namespace fc {

// known: the identifier's record, or null when it has none yet.
template <class T> int probe_slowly(fc_context &context, Probe *known, const Name &name, T *value);

template <class T> inline int probe_by_name(fc_context *ctx, const char *id, T *value) {
    fc_context &context = context_of(ctx);
    const Name name = read_name(id);
    Probe *probe = context.probes.find(name);
    if (probe != nullptr && probe->state[TypeOf<T>::value].load(std::memory_order_relaxed) == 0)
        return FC_OK;
    return probe_slowly(context, probe, name, value);
}

} // namespace fc
