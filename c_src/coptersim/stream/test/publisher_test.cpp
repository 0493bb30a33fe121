/* publisher_test.cpp: which URLs are taken, and which interface a table of routes leads to. */
#include "publisher.hpp"

#include "check.h"

#include <arpa/inet.h>
#include <sstream>

using namespace coptersim_stream;

namespace {

void good_urls() {
    multicast_place place;
    std::string error;
    CHECK(read_url(default_url, false, place, error));
    CHECK(place.group == "239.255.76.67" && place.port == 7667 && place.ttl == 0);
    CHECK(read_url("udpm://", false, place, error));
    CHECK(place.group == "239.255.76.67" && place.port == 7667);
    CHECK(read_url("udpm://224.1.2.3:8000", false, place, error));
    CHECK(place.group == "224.1.2.3" && place.port == 8000);
    CHECK(read_url("udpm://239.255.76.67:7667?ttl=1", true, place, error));
    CHECK_INT(place.ttl, 1);
}

void bad_urls() {
    const char *const cases[][2] = {
        {"tcpq://127.0.0.1", "udpm://GROUP:PORT?ttl=0 expected"},
        {"udpm://127.0.0.1:7667",
         "\"127.0.0.1\" is no multicast address (224.0.0.0 to 239.255.255.255)"},
        {"udpm://localhost",
         "\"localhost\" is no multicast address (224.0.0.0 to 239.255.255.255)"},
        {"udpm://239.255.76.67:0", "the port must be 1 to 65535, not \"0\""},
        {"udpm://239.255.76.67:", "the port must be 1 to 65535, not \"\""},
        {"udpm://239.255.76.67:7667?ttl=-1", "ttl must be 0 to 255, not \"-1\""},
        {"udpm://239.255.76.67:7667?ttl=99999999999999999999",
         "ttl must be 0 to 255, not \"99999999999999999999\""},
        {"udpm://239.255.76.67:7667?recv_buf_size=0", "recv_buf_size must be 1 to 2^30, not \"0\""},
        {"udpm://239.255.76.67:7667?ttl=0&x",
         "unknown option \"x\"; there are ttl and recv_buf_size"},
        {"udpm://239.255.76.67:7667?ttl=1",
         "ttl=1 lets packets leave this host; use ttl=0 (--allow-network allows it)"},
    };
    for (auto &c : cases) {
        multicast_place place;
        std::string error;
        CHECK(!read_url(c[0], false, place, error));
        CHECK(error == std::string(c[0]) + ": " + c[1]);
    }
}

/* A line of /proc/net/route; addresses are as they stand in memory. */
std::string route(const char *interface, const char *destination, const char *mask, int flags = 1) {
    char line[128];
    std::snprintf(line, sizeof line, "%s\t%08X\t00000000\t%04X\t0\t0\t0\t%08X\t0\t0\t0\n",
                  interface, inet_addr(destination), static_cast<unsigned int>(flags),
                  inet_addr(mask));
    return line;
}

std::string way(const std::string &routes) {
    std::istringstream table("Iface\tDestination\tGateway\n" + routes);
    return route_of("239.255.76.67", table);
}

void the_longest_prefix_leads() {
    std::string anywhere = route("eth0", "0.0.0.0", "0.0.0.0");
    std::string multicast = route("eth1", "224.0.0.0", "240.0.0.0");
    std::string group = route("lo", "239.255.76.67", "255.255.255.255");
    CHECK(way("").empty());
    CHECK(way(anywhere) == "eth0");
    CHECK(way(anywhere + multicast) == "eth1");
    CHECK(way(anywhere + multicast + group) == "lo");
    CHECK(way(group + multicast + anywhere) == "lo");
    CHECK(way(route("eth2", "192.168.0.0", "255.255.0.0")).empty());
    CHECK(way(anywhere + route("lo", "239.255.76.67", "255.255.255.255", 0)) == "eth0");
    CHECK(way("rubbish\n" + anywhere) == "eth0");
}

} // namespace

int main() {
    good_urls();
    bad_urls();
    the_longest_prefix_leads();
    return CHECK_RESULT();
}
