// A context's clock: the system's monotonic one, a function of the user, or moved by hand.
#pragma once

#include "fc_context.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace fc {

class Clock {
  public:
    // Nanoseconds. Without any lock held: a user's function is called.
    std::int64_t now() const;
    void use(fc_clock_fn function, void *user);
    void advance(std::int64_t ns);
    // The manual clock, whether or not it is the one in use.
    std::int64_t manual() const {
        return manual_ns_.load(std::memory_order_relaxed);
    }
    void set_manual(std::int64_t ns) {
        manual_ns_.store(ns, std::memory_order_relaxed);
    }

  private:
    struct Source {
        fc_clock_fn function;
        void *user;
    };
    enum class Kind { monotonic, manual, function };

    std::atomic<Kind> kind_{Kind::monotonic};
    std::atomic<std::int64_t> manual_ns_{0};
    std::atomic<const Source *> source_{nullptr};
    std::mutex lock_;
    std::vector<std::unique_ptr<Source>> sources_; // kept: a reader may still be using an old one
};

} // namespace fc
