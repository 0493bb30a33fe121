// A lock for sections of a few nanoseconds: one atomic exchange to take it, one store to give it
// back.
#pragma once

#include <atomic>
#include <sched.h>

namespace fc {

class SpinLock {
  public:
    void lock() {
        while (held_.exchange(true, std::memory_order_acquire))
            wait();
    }
    void unlock() {
        held_.store(false, std::memory_order_release);
    }

  private:
    // The holder may have lost its processor, so spinning gives way soon.
    void wait() const {
        for (int spin = 0; spin < 100; ++spin) {
            if (!held_.load(std::memory_order_relaxed))
                return;
#if defined(__x86_64__) || defined(__i386__)
            __builtin_ia32_pause();
#endif
        }
        sched_yield();
    }

    std::atomic<bool> held_{false};
};

} // namespace fc
