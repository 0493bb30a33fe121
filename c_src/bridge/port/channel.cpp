#include "channel.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>

namespace cb {

namespace {

constexpr std::size_t kHeader = 4;
constexpr std::uint32_t kLongestPacket = 256U << 20;

std::size_t read_some(int fd, char *place, std::size_t room) {
    for (;;) {
        const ssize_t got = ::read(fd, place, room);
        if (got >= 0) {
            return static_cast<std::size_t>(got);
        }
        if (errno != EINTR) {
            throw BrokenChannel(std::string("cannot read: ") + std::strerror(errno));
        }
    }
}

} // namespace

// At least `wanted` bytes in the buffer; false at the end of input.
bool Channel::fill(std::size_t wanted) {
    if (end_ - start_ >= wanted) {
        return true;
    }
    std::memmove(buffer_.data(), buffer_.data() + start_, end_ - start_);
    end_ -= start_;
    start_ = 0;
    while (end_ < wanted) {
        const std::size_t got = read_some(in_, buffer_.data() + end_, buffer_.size() - end_);
        if (got == 0) {
            return false;
        }
        end_ += got;
    }
    return true;
}

bool Channel::read(std::vector<char> &packet) {
    if (!fill(kHeader)) {
        if (end_ != start_) {
            throw BrokenChannel("input ends within the length of a packet");
        }
        return false;
    }
    std::uint32_t length = 0;
    for (std::size_t i = 0; i < kHeader; ++i) {
        length = length << 8 | static_cast<unsigned char>(buffer_[start_ + i]);
    }
    if (length > kLongestPacket) {
        throw BrokenChannel("a packet of " + std::to_string(length) + " bytes; " +
                            std::to_string(kLongestPacket) + " are allowed");
    }
    start_ += kHeader;
    packet.resize(length);
    const std::size_t present = std::min<std::size_t>(length, end_ - start_);
    std::memcpy(packet.data(), buffer_.data() + start_, present);
    start_ += present;
    for (std::size_t have = present; have < length;) {
        // Short rests go through the buffer, so that what follows them is read too; long ones do
        // not.
        if (length - have <= buffer_.size() && fill(length - have)) {
            std::memcpy(packet.data() + have, buffer_.data() + start_, length - have);
            start_ += length - have;
            break;
        }
        const std::size_t got = length - have > buffer_.size()
                                    ? read_some(in_, packet.data() + have, length - have)
                                    : 0;
        if (got == 0) {
            throw BrokenChannel("input ends within a packet of " + std::to_string(length) +
                                " bytes");
        }
        have += got;
    }
    return true;
}

void Channel::write(std::string_view packet) {
    while (!packet.empty()) {
        const ssize_t written = ::write(out_, packet.data(), packet.size());
        if (written >= 0) {
            packet.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            throw BrokenChannel(std::string("cannot write: ") + std::strerror(errno));
        }
    }
}

} // namespace cb
