// Coverage counters of gcov: each library has its own copy of the run-time, so each is asked by
// itself.
#include "session.hpp"

namespace cb {

namespace {

using Action = void (*)();

Action exported_action(const Mapped &library, const char *name) {
    return reinterpret_cast<Action>(LoadedLibrary::symbol_of(library, name));
}

} // namespace

unsigned Session::flush_coverage() {
    unsigned flushed = 0;
    for (const Part &part : parts_) {
        const Action dump = exported_action(part.mapped, "__gcov_dump");
        const Action reset = exported_action(part.mapped, "__gcov_reset");
        if (dump != nullptr) {
            dump();
            ++flushed;
        }
        if (dump != nullptr && reset != nullptr) { // without it, counts after a dump are lost
            reset();
        }
    }
    return flushed;
}

unsigned Session::reset_coverage() {
    unsigned count = 0;
    for (const Part &part : parts_) {
        if (const Action reset = exported_action(part.mapped, "__gcov_reset")) {
            reset();
            ++count;
        }
    }
    return count;
}

} // namespace cb
