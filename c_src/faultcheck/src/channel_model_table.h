// The models of channels by name.
#pragma once

#include "named.h"

namespace fc {

// A fault id, or FC_E_ with everything reported. Throws std::bad_alloc.
fc_fault_id arm_channel_model(fc_context *ctx, const char *channel, const char *name,
                              const fc_argument *arguments, std::size_t count);

} // namespace fc
