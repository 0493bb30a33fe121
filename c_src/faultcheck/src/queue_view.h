// What one get does to a queue: seen at once by the faults that follow, done only at commit.
#pragma once

#include "packet_queue.h"

#include <cstdint>

namespace fc {

class QueueView {
  public:
    QueueView(PacketQueue &queue, std::uint64_t gets, std::int64_t now)
        : queue_(queue), gets_(gets), now_(now) {}

    bool is_of(const PacketQueue &queue) const {
        return &queue_ == &queue;
    }

    // Takes the next packet. False when none can be seen.
    bool take(std::string *packet) {
        while (!front_.empty()) {
            QueuedPacket &top = front_.back();
            if (top.copies > 0) {
                *packet = top.bytes;
                --top.copies;
                return true;
            }
            front_.pop_back();
        }
        if (!sees_next())
            return false;
        *packet = queue_.entry(position_).bytes;
        skip(1);
        return true;
    }

    // Discards at most that many packets that can be seen; returns how many.
    std::uint64_t discard(std::uint64_t packets) {
        std::uint64_t done = 0;
        while (done < packets && !front_.empty()) {
            const std::uint64_t removed = std::min(packets - done, front_.back().copies);
            front_.back().copies -= removed;
            done += removed;
            if (front_.back().copies == 0)
                front_.pop_back();
        }
        while (done < packets && sees_next())
            done += skip(packets - done);
        return done;
    }

    void put_back(const std::string &bytes, std::uint64_t copies) {
        front_.push_back({bytes, copies, Hiding()});
    }

    // The part of commit that may fail.
    void reserve_for_commit() {
        queue_.reserve(front_.size());
    }

    // After reserve_for_commit: cannot fail.
    void commit() noexcept {
        queue_.remove_front(taken_);
        for (QueuedPacket &packet : front_)
            if (packet.copies > 0)
                queue_.push_front(std::move(packet));
    }

  private:
    bool sees_next() const {
        return position_ < queue_.entries() && queue_.entry(position_).hiding.over(gets_, now_);
    }

    // Within one entry; returns how many.
    std::uint64_t skip(std::uint64_t packets) {
        const std::uint64_t left = queue_.entry(position_).copies - used_;
        const std::uint64_t here = std::min(packets, left);
        taken_ += here;
        used_ += here;
        if (here == left) {
            ++position_;
            used_ = 0;
        }
        return here;
    }

    PacketQueue &queue_;
    const std::uint64_t gets_;
    const std::int64_t now_;
    std::vector<QueuedPacket> front_; // put back; the last is the next to be taken
    std::uint64_t taken_ = 0;         // packets of the queue
    std::size_t position_ = 0;        // the entry the next packet is in
    std::uint64_t used_ = 0;          // copies of that entry already taken
};

} // namespace fc
