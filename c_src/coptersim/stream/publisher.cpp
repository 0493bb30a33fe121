/* publisher.cpp: checks before liblcm does anything, because it cannot be told an interface. */
#include "publisher.hpp"

#include <arpa/inet.h>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <lcm/lcm-cpp.hpp>
#include <sstream>

namespace coptersim_stream {
namespace {

bool wrong(const std::string &url, const std::string &what, std::string &error) {
    error = url + ": " + what;
    return false;
}

bool read_whole(const std::string &text, long low, long high, int &number) {
    char *end = nullptr;
    errno = 0;
    long value = std::strtol(text.c_str(), &end, 10);
    number = static_cast<int>(value);
    bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    return digits && errno == 0 && value >= low && value <= high;
}

bool is_multicast(const std::string &address) {
    in_addr binary{};
    return inet_pton(AF_INET, address.c_str(), &binary) == 1 && (ntohl(binary.s_addr) >> 28) == 0xe;
}

bool read_option(const std::string &url, const std::string &option, multicast_place &place,
                 std::string &error) {
    std::size_t equals = option.find('=');
    std::string name = option.substr(0, equals);
    std::string value = equals == std::string::npos ? "" : option.substr(equals + 1);
    int size = 0;
    if (name == "ttl") {
        return read_whole(value, 0, 255, place.ttl) ||
               wrong(url, "ttl must be 0 to 255, not \"" + value + "\"", error);
    }
    if (name == "recv_buf_size") {
        return read_whole(value, 1, 1 << 30, size) ||
               wrong(url, "recv_buf_size must be 1 to 2^30, not \"" + value + "\"", error);
    }
    return wrong(url, "unknown option \"" + option + "\"; there are ttl and recv_buf_size", error);
}

bool read_place(const std::string &url, const std::string &text, multicast_place &place,
                std::string &error) {
    std::size_t colon = text.find(':');
    if (!text.empty()) {
        place.group = text.substr(0, colon);
    }
    if (!is_multicast(place.group)) {
        return wrong(
            url, "\"" + place.group + "\" is no multicast address (224.0.0.0 to 239.255.255.255)",
            error);
    }
    return colon == std::string::npos || read_whole(text.substr(colon + 1), 1, 65535, place.port) ||
           wrong(url, "the port must be 1 to 65535, not \"" + text.substr(colon + 1) + "\"", error);
}

std::uint32_t binary_of(const std::string &address) {
    in_addr binary{};
    inet_pton(AF_INET, address.c_str(), &binary);
    return binary.s_addr;
}

std::string remedy(const std::string &group) {
    return "; as root run: ip route replace " + group + "/32 dev lo src 127.0.0.1";
}

} // namespace

std::string route_of(const std::string &group, std::istream &table) {
    constexpr unsigned int up = 1;
    std::uint32_t address = binary_of(group);
    std::string line, interface, best;
    std::uint32_t longest = 0;
    std::getline(table, line); /* the names of the columns */
    while (std::getline(table, line)) {
        std::istringstream fields(line);
        std::uint32_t destination = 0, gateway = 0, mask = 0;
        unsigned int flags = 0;
        long count = 0, use = 0, metric = 0;
        fields >> interface >> std::hex >> destination >> gateway >> flags >> std::dec >> count >>
            use >> metric >> std::hex >> mask;
        bool goes = fields && (flags & up) != 0 && (address & mask) == destination;
        /* A longer mask has more bits, and so is the larger number in the order of the host. */
        if (goes && (best.empty() || ntohl(mask) > longest)) {
            longest = ntohl(mask);
            best = interface;
        }
    }
    return best;
}

bool read_url(const std::string &url, bool allow_network, multicast_place &place,
              std::string &error) {
    static const std::string scheme = "udpm://";
    if (url.compare(0, scheme.size(), scheme) != 0) {
        return wrong(url, "udpm://GROUP:PORT?ttl=0 expected", error);
    }
    std::size_t question = url.find('?');
    if (!read_place(url, url.substr(scheme.size(), question - scheme.size()), place, error)) {
        return false;
    }
    while (question != std::string::npos) {
        std::size_t next = url.find('&', question + 1);
        std::string option = url.substr(question + 1, next - question - 1);
        if (!read_option(url, option, place, error)) {
            return false;
        }
        question = next;
    }
    return place.ttl == 0 || allow_network ||
           wrong(url,
                 "ttl=" + std::to_string(place.ttl) +
                     " lets packets leave this host; use ttl=0 (--allow-network allows it)",
                 error);
}

bool has_loopback_route(const multicast_place &place, std::string &error) {
    std::ifstream table("/proc/net/route");
    std::string interface = route_of(place.group, table);
    if (interface.empty()) {
        return wrong(place.group, "there is no route to it" + remedy(place.group), error);
    }
    return interface == "lo" || wrong(place.group,
                                      "the route to it leaves this host through " + interface +
                                          " (--allow-network allows it)" + remedy(place.group),
                                      error);
}

publisher::publisher() = default;
publisher::~publisher() = default;

bool publisher::open(const std::string &url, bool allow_network, std::string &error) {
    multicast_place place;
    if (!read_url(url, allow_network, place, error) ||
        (!allow_network && !has_loopback_route(place, error))) {
        return false;
    }
    url_ = url;
    lcm_ = std::make_unique<lcm::LCM>(url);
    return lcm_->good() || wrong(url, "liblcm cannot use it", error);
}

bool publisher::put(std::uint64_t, const char *channel, std::string_view bytes,
                    std::string &error) {
    return lcm_->publish(channel, bytes.data(), static_cast<unsigned int>(bytes.size())) == 0 ||
           wrong(url_, std::string("cannot send: ") + std::strerror(errno), error);
}

} // namespace coptersim_stream
