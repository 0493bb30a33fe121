#include "clock.h"

#include <ctime>

namespace fc {

std::int64_t Clock::now() const {
    const Kind kind = kind_.load(std::memory_order_acquire);
    if (kind == Kind::manual)
        return manual_ns_.load(std::memory_order_relaxed);
    if (kind == Kind::function) {
        const Source *source = source_.load(std::memory_order_acquire);
        return source->function(source->user);
    }
    timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return std::int64_t{1000000000} * time.tv_sec + time.tv_nsec;
}

void Clock::use(fc_clock_fn function, void *user) {
    const std::lock_guard<std::mutex> hold(lock_);
    if (function == nullptr) {
        kind_.store(Kind::monotonic, std::memory_order_release);
        return;
    }
    for (const auto &known : sources_)
        if (known->function == function && known->user == user) {
            source_.store(known.get(), std::memory_order_release);
            kind_.store(Kind::function, std::memory_order_release);
            return;
        }
    sources_.push_back(std::make_unique<Source>(Source{function, user}));
    source_.store(sources_.back().get(), std::memory_order_release);
    kind_.store(Kind::function, std::memory_order_release);
}

void Clock::advance(std::int64_t ns) {
    manual_ns_.fetch_add(ns, std::memory_order_relaxed);
    kind_.store(Kind::manual, std::memory_order_release);
}

} // namespace fc
