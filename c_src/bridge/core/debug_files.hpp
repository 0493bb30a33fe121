// Finding separate debug files on this machine only.
#pragma once

#include <elfutils/libdwfl.h>

namespace cb {

// For Dwfl: local build-id and debuglink search, no network whatever the environment says.
const Dwfl_Callbacks &local_debug_files();

} // namespace cb
