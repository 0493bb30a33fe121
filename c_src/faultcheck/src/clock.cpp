#include "clock.h"

#include <ctime>

namespace fc {

std::int64_t Clock::now() const {
    const Source source = this->source();
    if (source.manual)
        return source.manual_ns;
    if (source.function != nullptr)
        return source.function(source.user);
    timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return std::int64_t{1000000000} * time.tv_sec + time.tv_nsec;
}

void Clock::use(fc_clock_fn function, void *user) {
    const std::lock_guard<SpinLock> hold(lock_);
    source_.function = function;
    source_.user = user;
    source_.manual = false;
}

void Clock::advance(std::int64_t ns) {
    const std::lock_guard<SpinLock> hold(lock_);
    source_.manual = true;
    source_.manual_ns += ns;
}

void Clock::reset() {
    const std::lock_guard<SpinLock> hold(lock_);
    source_.manual_ns = 0;
}

Clock::Source Clock::source() const {
    const std::lock_guard<SpinLock> hold(lock_);
    return source_;
}

} // namespace fc
