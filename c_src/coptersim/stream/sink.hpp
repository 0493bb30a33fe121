/* sink.hpp: where messages go. */
#ifndef CSIM_STREAM_SINK_HPP
#define CSIM_STREAM_SINK_HPP

#include <cstdint>
#include <string>
#include <string_view>

namespace coptersim_stream {

class sink {
  public:
    virtual ~sink() = default;

    /* One message, encoded, with its simulated time. false: error is one line. */
    virtual bool put(std::uint64_t t_us, const char *channel, std::string_view bytes,
                     std::string &error) = 0;
};

/* As LCM sends it, with the fingerprint. */
template <class M> std::string encoded(const M &message) {
    std::string bytes(static_cast<std::size_t>(message.getEncodedSize()), '\0');
    int size = message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    bytes.resize(size < 0 ? 0 : static_cast<std::size_t>(size));
    return bytes;
}

} // namespace coptersim_stream

#endif
