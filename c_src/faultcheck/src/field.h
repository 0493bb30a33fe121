// A model on a typed field of a packet.
#pragma once

#include "apply.h"
#include "fc_channel.h"

#include <string>

namespace fc {

// FC_OK, or why the packet was left as it was: FC_E_INDEX when it does not have the field, or as
// apply.
int apply_to_field(const FaultCall &call, const fc_field &field, std::string *packet);

} // namespace fc
