// What the port program leaves in its log when a signal ends it. The format is in
// docs/architecture.md.
#pragma once

namespace cb {

// Handlers write to fd 2 on a stack of their own, then the signal takes its usual effect. Under
// AddressSanitizer, which reports by itself, only SIGQUIT is handled.
void install_crash_handlers();

} // namespace cb
