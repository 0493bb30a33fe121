/* options.hpp: the command line of coptersim_stream. */
#ifndef CSIM_STREAM_OPTIONS_HPP
#define CSIM_STREAM_OPTIONS_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace coptersim_stream {

struct options {
    bool help = false;
    bool allow_network = false;
    std::string url; /* empty: nothing is published */
    std::string log; /* empty: no log */
    double speed = 1;
    std::optional<std::int32_t> observer;
    std::vector<std::string> settings; /* name=value */
    std::string scenario;
};

extern const char *const help_text;

/* false: error is one line. */
bool parse_options(int argc, char **argv, options &result, std::string &error);

} // namespace coptersim_stream

#endif
