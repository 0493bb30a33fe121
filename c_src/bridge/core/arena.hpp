// Memory of one call: argument buffers, argument slots, the result. Freed all at once.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

namespace cb {

class Arena {
  public:
    Arena();
    // Zeroed memory, aligned to 16 bytes. Throws std::bad_alloc.
    void *take(std::size_t bytes);
    // The same, not zeroed.
    void *take_raw(std::size_t bytes);
    void clear() {
        used_ = 0;
        if (!extra_.empty()) {
            extra_.clear();
        }
    }

  private:
    static constexpr std::size_t kFirstBlock = 16 * 1024;
    struct Free {
        void operator()(void *memory) const;
    };
    std::unique_ptr<unsigned char[]> first_;
    std::size_t used_ = 0;
    std::vector<std::unique_ptr<void, Free>> extra_;
    bool separate_; // a block of its own for each buffer, so that AddressSanitizer sees its ends
};

} // namespace cb
