// A copy of a library's writable memory and putting it back.
#pragma once

#include "library.hpp"

#include <vector>

namespace cb {

class Snapshot {
  public:
    // `excluded` is left alone by restore() (coverage counters).
    void take(const std::vector<Range> &ranges, std::vector<Range> excluded);
    // False if there is nothing to restore.
    bool restore() const;
    void clear();

  private:
    std::vector<Range> ranges_;
    std::vector<unsigned char> saved_;
};

} // namespace cb
