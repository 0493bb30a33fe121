#include "stub.hpp"

#include "error.hpp"

#include <cstring>

namespace cb {

namespace {

// Asking waits for an answer from the process that made the call: only the port program can do
// that.
void refuse(const char *function, void **, void *) {
    fail("callback", Tree::atom(function), Tree::atom("no_port"));
}

StubCallback stub_callback = refuse;

} // namespace

void set_stub_callback(StubCallback callback) {
    stub_callback = callback;
}

void connect_stubs(const Mapped &library) {
    if (void *place = LoadedLibrary::symbol_of(library, "c_bridge_stub_callback")) {
        std::memcpy(place, &stub_callback, sizeof stub_callback);
    }
}

} // namespace cb
