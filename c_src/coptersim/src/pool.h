// Runs the parts of one piece of work on several threads.
//
// Which thread runs a part decides nothing: parts write to different places and read what no part
// writes.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace coptersim {

class Pool {
  public:
    // Threads in all, the caller's among them.
    explicit Pool(int threads);
    ~Pool();
    Pool(const Pool &) = delete;
    Pool &operator=(const Pool &) = delete;

    int threads() const {
        return static_cast<int>(workers_.size()) + 1;
    }

    // work(part) for each part 0..threads()-1; returns when all are done, and throws on what the
    // first of them threw.
    template <class Work> void run(const Work &work) {
        run_parts([](const void *w, int part) { (*static_cast<const Work *>(w))(part); }, &work);
    }

  private:
    using Call = void (*)(const void *work, int part);
    void run_parts(Call call, const void *work);
    void serve(int part);
    void stop();

    std::mutex lock_;
    std::condition_variable wake_, done_;
    Call call_ = nullptr;
    const void *work_ = nullptr;
    unsigned long round_ = 0;
    std::size_t busy_ = 0;
    bool stopping_ = false;
    std::exception_ptr failure_;
    std::vector<std::thread> workers_;
};

} // namespace coptersim
