/* publisher.hpp: sends messages by liblcm, to this host only unless the network is allowed. */
#ifndef CSIM_STREAM_PUBLISHER_HPP
#define CSIM_STREAM_PUBLISHER_HPP

#include "sink.hpp"

#include <istream>
#include <memory>

namespace lcm {
class LCM;
}

namespace coptersim_stream {

constexpr const char *default_url = "udpm://239.255.76.67:7667?ttl=0&recv_buf_size=2097152";

/* What liblcm would do with a URL. */
struct multicast_place {
    std::string group = "239.255.76.67";
    int port = 7667;
    int ttl = 0;
};

/* udpm://[GROUP[:PORT]][?ttl=N&recv_buf_size=N]. false: error is one line. Also refused is what
 * lets packets leave this host. */
bool read_url(const std::string &url, bool allow_network, multicast_place &place,
              std::string &error);

/* Whether packets for the group go through the loopback interface; liblcm takes the kernel's route.
 * false: error is one line that says what to run. */
bool has_loopback_route(const multicast_place &place, std::string &error);

/* The interface that packets for an address go through by a table in the form of /proc/net/route:
 * the one of the longest prefix, the first of equals. "" for none. */
std::string route_of(const std::string &group, std::istream &table);

class publisher : public sink {
  public:
    publisher();
    ~publisher() override;

    /* false: error is one line. */
    bool open(const std::string &url, bool allow_network, std::string &error);
    bool put(std::uint64_t t_us, const char *channel, std::string_view bytes,
             std::string &error) override;

  private:
    std::unique_ptr<lcm::LCM> lcm_;
    std::string url_;
};

} // namespace coptersim_stream

#endif
