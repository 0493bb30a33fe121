// Which reset suits a library, from what it imports and runs at load.
#pragma once

#include "debug_info.hpp"
#include "library.hpp"

#include <string>
#include <vector>

namespace cb {

// Why putting back its memory would not bring the library to where it started; empty if nothing
// speaks against it.
std::vector<std::string> against_snapshot(const Mapped &library, const DebugInfo *info);

} // namespace cb
