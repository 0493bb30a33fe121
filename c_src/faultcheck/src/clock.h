// A context's clock: the system's monotonic one, a function of the user, or moved by hand.
#pragma once

#include "fc_context.h"
#include "spin_lock.h"

#include <mutex>

namespace fc {

class Clock {
  public:
    // Nanoseconds. Without any lock held: a user's function is called.
    std::int64_t now() const;
    void use(fc_clock_fn function, void *user);
    void advance(std::int64_t ns);
    // The manual clock back to 0.
    void reset();

  private:
    struct Source {
        fc_clock_fn function = nullptr; // null: monotonic, unless manual
        void *user = nullptr;
        bool manual = false;
        std::int64_t manual_ns = 0;
    };
    Source source() const;

    mutable SpinLock lock_;
    Source source_;
};

} // namespace fc
