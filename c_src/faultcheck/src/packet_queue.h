// The packets waiting for one receiver, and a view that changes them all at once or not at all.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace fc {

// A packet and how many times in a row it stands in the queue: a repetition costs no copies.
struct QueuedPacket {
    std::string bytes;
    std::uint64_t copies = 1;
};

// A ring whose slots keep their buffers, so that steady traffic allocates nothing.
class PacketQueue {
  public:
    bool empty() const {
        return count_ == 0;
    }
    std::uint64_t depth() const {
        return depth_;
    }
    std::size_t entries() const {
        return count_;
    }
    const QueuedPacket &entry(std::size_t position) const {
        return ring_[(head_ + position) & (ring_.size() - 1)];
    }

    void push_back(const char *data, std::size_t size) {
        reserve(1);
        QueuedPacket &slot = ring_[(head_ + count_) & (ring_.size() - 1)];
        slot.bytes.assign(data, size);
        slot.copies = 1;
        ++count_;
        ++depth_;
    }

    // Room for that many more entries.
    void reserve(std::size_t more) {
        if (count_ + more > ring_.size())
            grow(count_ + more);
    }

    // After reserve: cannot fail.
    void push_front(QueuedPacket &&packet) noexcept {
        head_ = (head_ - 1) & (ring_.size() - 1);
        ring_[head_].bytes.swap(packet.bytes);
        ring_[head_].copies = packet.copies;
        ++count_;
        depth_ += packet.copies;
    }

    // packets <= depth()
    void remove_front(std::uint64_t packets) noexcept {
        depth_ -= packets;
        while (packets > 0) {
            QueuedPacket &front = ring_[head_];
            const std::uint64_t removed = std::min(packets, front.copies);
            packets -= removed;
            front.copies -= removed;
            if (front.copies == 0) {
                head_ = (head_ + 1) & (ring_.size() - 1);
                --count_;
            }
        }
    }

    void clear() noexcept {
        head_ = count_ = 0;
        depth_ = 0;
    }

  private:
    void grow(std::size_t least) {
        std::size_t size = std::max<std::size_t>(8, ring_.size());
        while (size < least)
            size *= 2;
        std::vector<QueuedPacket> next(size);
        for (std::size_t at = 0; at < count_; ++at)
            next[at] = std::move(ring_[(head_ + at) & (ring_.size() - 1)]);
        ring_.swap(next);
        head_ = 0;
    }

    std::vector<QueuedPacket> ring_; // size 0 or a power of two
    std::size_t head_ = 0;
    std::size_t count_ = 0;
    std::uint64_t depth_ = 0; // copies counted
};

// What one get does to a queue: nothing until commit.
class QueueView {
  public:
    explicit QueueView(PacketQueue &queue) : queue_(queue) {}

    // Takes the next packet. False when none is left.
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
        if (taken_ == queue_.depth())
            return false;
        *packet = queue_.entry(position_).bytes;
        skip(1);
        return true;
    }

    std::uint64_t depth() const {
        std::uint64_t sum = queue_.depth() - taken_;
        for (const QueuedPacket &packet : front_)
            sum += packet.copies;
        return sum;
    }

    // packets <= depth()
    void discard(std::uint64_t packets) {
        while (packets > 0 && !front_.empty()) {
            const std::uint64_t removed = std::min(packets, front_.back().copies);
            front_.back().copies -= removed;
            packets -= removed;
            if (front_.back().copies == 0)
                front_.pop_back();
        }
        skip(packets);
    }

    void put_back(const std::string &bytes, std::uint64_t copies) {
        front_.push_back({bytes, copies});
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
    void skip(std::uint64_t packets) {
        taken_ += packets;
        while (packets > 0) {
            const std::uint64_t left = queue_.entry(position_).copies - used_;
            const std::uint64_t here = std::min(packets, left);
            packets -= here;
            used_ += here;
            if (here == left) {
                ++position_;
                used_ = 0;
            }
        }
    }

    PacketQueue &queue_;
    std::vector<QueuedPacket> front_; // put back; the last is the next to be taken
    std::uint64_t taken_ = 0;         // packets of the queue
    std::size_t position_ = 0;        // the entry the next packet is in
    std::uint64_t used_ = 0;          // copies of that entry already taken
};

} // namespace fc
