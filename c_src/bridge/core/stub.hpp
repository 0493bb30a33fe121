// Stubs in a library under test that ask for their answer.
//
// Such a library has a global `void (*c_bridge_stub_callback)(const char *function, void
// **arguments, void *result)`, which is set when the library is loaded. arguments[i] points to
// argument i, result to room for what the stub returns (NULL: nothing). A callback may throw Error:
// the call that led to the stub ends with it.
#pragma once

#include "library.hpp"

namespace cb {

using StubCallback = void (*)(const char *function, void **arguments, void *result);

// What stubs of libraries that are loaded from now on call. Until it is set they end with
// {callback, F, no_port}.
void set_stub_callback(StubCallback callback);
void connect_stubs(const Mapped &library);

} // namespace cb
