// The faults' state before a get or put, to be put back when it fails.
#pragma once

#include "channel.h"

namespace fc {

class Checkpoint {
  public:
    Checkpoint(Channel &channel, std::size_t receiver) : channel_(channel), receiver_(receiver) {
        before_.reserve(channel.faults.size());
        for (const ChannelFault &fault : channel.faults)
            before_.push_back({fault, fault.runs[receiver]});
    }
    void restore() noexcept {
        for (std::size_t at = 0; at < before_.size(); ++at) {
            static_cast<Fault &>(channel_.faults[at]) = before_[at].fault;
            std::swap(channel_.faults[at].runs[receiver_], before_[at].run);
        }
    }

  private:
    struct Before {
        Fault fault;
        FaultRun run;
    };
    Channel &channel_;
    std::size_t receiver_;
    std::vector<Before> before_;
};

} // namespace fc
