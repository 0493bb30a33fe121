// The packets waiting for one receiver.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace fc {

// From when on a delayed packet can be seen by its receiver.
struct Hiding {
    std::uint64_t until_get = 0; // number of gets the receiver has made
    std::int64_t until_ns = std::numeric_limits<std::int64_t>::min();

    bool over(std::uint64_t gets, std::int64_t now) const {
        return until_get <= gets && until_ns <= now;
    }
};

// A packet and how many times in a row it stands in the queue: a repetition costs no copies.
struct QueuedPacket {
    std::string bytes;
    std::uint64_t copies = 1;
    Hiding hiding;
};

// A ring whose slots keep their buffers, so that steady traffic allocates nothing.
class PacketQueue {
  public:
    PacketQueue() = default;
    PacketQueue(PacketQueue &&) = default;
    PacketQueue &operator=(PacketQueue &&) = default;
    // The packets, not the buffers of those gone.
    PacketQueue(const PacketQueue &other) : count_(other.count_), depth_(other.depth_) {
        if (count_ > 0)
            ring_.resize(size_for(count_));
        for (std::size_t at = 0; at < count_; ++at)
            ring_[at] = other.entry(at);
    }

    std::uint64_t depth() const {
        return depth_;
    } // copies counted
    std::size_t entries() const {
        return count_;
    }
    const QueuedPacket &entry(std::size_t position) const {
        return slot(position);
    }

    // Everything of push_back that may fail.
    void prepare_back(std::size_t size) {
        reserve(1);
        slot(count_).bytes.reserve(std::max(size, kLeastBuffer));
    }
    // After prepare_back with that size: cannot fail.
    void push_back(const char *data, std::size_t size, const Hiding &hiding) noexcept {
        QueuedPacket &back = slot(count_);
        back.bytes.assign(data, size);
        back.copies = 1;
        back.hiding = hiding;
        ++count_;
        ++depth_;
    }

    // Room for that many more entries.
    void reserve(std::size_t more) {
        if (count_ + more > ring_.size())
            grow(count_ + more);
    }
    // After reserve: cannot fail. Copies that nobody will live to take are not counted.
    void push_front(QueuedPacket &&packet) noexcept {
        const std::uint64_t copies = std::min(packet.copies, kMostDepth - depth_);
        if (copies == 0)
            return;
        head_ = (head_ - 1) & (ring_.size() - 1);
        ring_[head_].bytes.swap(packet.bytes);
        ring_[head_].copies = copies;
        ring_[head_].hiding = packet.hiding;
        ++count_;
        depth_ += copies;
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

    // The head, removed; there is one. Fails without a change.
    void take_front(std::string *packet) {
        if (ring_[head_].copies == 1)
            packet->swap(ring_[head_].bytes);
        else
            *packet = ring_[head_].bytes;
        remove_front(1);
    }

    void clear() noexcept {
        head_ = count_ = 0;
        depth_ = 0;
    }

  private:
    QueuedPacket &slot(std::size_t position) {
        return ring_[(head_ + position) & (ring_.size() - 1)];
    }
    const QueuedPacket &slot(std::size_t position) const {
        return ring_[(head_ + position) & (ring_.size() - 1)];
    }

    // What fc_channel_depth can tell.
    static constexpr std::uint64_t kMostDepth = std::numeric_limits<std::int64_t>::max();
    // More than a std::string holds within itself: then packets change hands by swapping pointers.
    static constexpr std::size_t kLeastBuffer = 32;

    static std::size_t size_for(std::size_t entries) {
        std::size_t size = 8;
        while (size < entries)
            size *= 2;
        return size;
    }

    void grow(std::size_t least) {
        std::vector<QueuedPacket> next(size_for(least));
        for (std::size_t at = 0; at < count_; ++at)
            next[at] = std::move(slot(at));
        ring_.swap(next);
        head_ = 0;
    }

    std::vector<QueuedPacket> ring_; // size 0 or a power of two
    std::size_t head_ = 0;
    std::size_t count_ = 0;
    std::uint64_t depth_ = 0;
};

} // namespace fc
