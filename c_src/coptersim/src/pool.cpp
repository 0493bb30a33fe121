#include "pool.h"

namespace coptersim {

Pool::Pool(int threads) {
    workers_.reserve(static_cast<std::size_t>(threads - 1));
    try {
        for (int part = 1; part < threads; ++part)
            workers_.emplace_back([this, part] { serve(part); });
    } catch (...) {
        stop();
        throw;
    }
}

Pool::~Pool() {
    stop();
}

void Pool::stop() {
    {
        const std::lock_guard<std::mutex> hold(lock_);
        stopping_ = true;
    }
    wake_.notify_all();
    for (std::thread &worker : workers_)
        worker.join();
}

void Pool::run_parts(Call call, const void *work) {
    if (workers_.empty()) {
        call(work, 0);
        return;
    }
    {
        const std::lock_guard<std::mutex> hold(lock_);
        call_ = call;
        work_ = work;
        busy_ = workers_.size();
        ++round_;
        failure_ = nullptr;
    }
    wake_.notify_all();
    std::exception_ptr own;
    try {
        call(work, 0);
    } catch (...) {
        own = std::current_exception();
    }
    std::unique_lock<std::mutex> hold(lock_);
    done_.wait(hold, [this] { return busy_ == 0; });
    if (own != nullptr || failure_ != nullptr)
        std::rethrow_exception(own != nullptr ? own : failure_);
}

void Pool::serve(int part) {
    unsigned long seen = 0;
    std::unique_lock<std::mutex> hold(lock_);
    for (;;) {
        wake_.wait(hold, [&] { return stopping_ || round_ != seen; });
        if (stopping_)
            return;
        seen = round_;
        const Call call = call_;
        const void *work = work_;
        hold.unlock();
        std::exception_ptr failure;
        try {
            call(work, part);
        } catch (...) {
            failure = std::current_exception();
        }
        hold.lock();
        if (failure != nullptr)
            failure_ = failure;
        if (--busy_ == 0)
            done_.notify_one();
    }
}

} // namespace coptersim
