// Packets with a four byte length, over two file descriptors.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace cb {

class BrokenChannel : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

class Channel {
  public:
    Channel(int in, int out) : in_(in), out_(out), buffer_(64 * 1024) {}
    // False at the end of input. Throws BrokenChannel when it ends within a packet, or a packet is
    // too long.
    bool read(std::vector<char> &packet);
    // A whole packet with its length. Throws BrokenChannel.
    void write(std::string_view packet);
    // Forgets what has been read ahead: after a fork it belongs to the child.
    void forget_input() {
        start_ = end_ = 0;
    }

  private:
    bool fill(std::size_t wanted);

    int in_;
    int out_;
    std::vector<char> buffer_;
    std::size_t start_ = 0;
    std::size_t end_ = 0;
};

} // namespace cb
