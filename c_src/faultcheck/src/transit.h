// A packet on its way to the receiver while the faults met at the get are walked.
#pragma once

#include "channel.h"
#include "queue_view.h"

#include <cstdint>
#include <deque>

namespace fc {

class Transit {
  public:
    Transit(Receiver &receiver, const CallInputs &inputs);

    bool present = false; // there is a packet to deliver
    bool blocked = false; // and none may be chosen any more
    std::string current;
    std::string clean; // current before any alteration

    QueueView &queue() {
        return views_.front();
    }

    // The head of the queue becomes the packet to deliver, if there is one.
    void take_next();
    // Another packet than the one at the head is delivered.
    void choose(const std::string &packet);
    // The head of another queue is; false: there is none.
    bool choose_from(PacketQueue &other, std::uint64_t gets);
    // The packet at that position, or the last one before it.
    void choose_position(std::uint64_t position);
    void block();

    void reserve_for_commit();
    void commit() noexcept;

  private:
    void give_back();
    QueueView &view_of(PacketQueue &queue, std::uint64_t gets);

    const std::int64_t now_;
    std::deque<QueueView> views_; // the receiver's own queue first
    QueueView *source_ = nullptr; // where `clean` was taken from; null: nowhere
};

} // namespace fc
