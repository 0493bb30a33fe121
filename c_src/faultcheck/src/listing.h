// A copy of what a context has seen and armed, made under its locks and read without them.
#pragma once

#include "context.h"
#include "fc_list.h"

#include <deque>

namespace fc {

struct Listed {
    std::string id;
    fc_listed entry;
    std::vector<fc_listed_fault> faults;
};

class Listing {
  public:
    // Throws std::bad_alloc.
    explicit Listing(fc_context &context);

    // Sorted by name, pointers set.
    const std::deque<Listed> &all() const {
        return all_;
    }

  private:
    void add(const Probe &probe);
    void add(const Channel &channel);
    void add_fault(Listed &listed, const ChannelFault &fault, const FaultRun &run,
                   const std::string &receiver);

    std::deque<Listed> all_;
    std::deque<std::string> receivers_; // names the faults point to
};

} // namespace fc
