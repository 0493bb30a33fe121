/* options.hpp: the command line of coptersim_run. */
#ifndef CSIM_RUN_OPTIONS_HPP
#define CSIM_RUN_OPTIONS_HPP

#include <optional>
#include <string>
#include <vector>

namespace coptersim_run {

struct search_range {
    std::string name;
    double low, high;
};

struct options {
    bool help = false;
    bool csv = false;
    bool replay = false;
    bool fail_on_collision = false;
    int threads = 1;
    std::string build; /* of csim_build_at; empty: the fastest */
    double speed = 1;
    double part_ms = 17;
    std::vector<std::string> settings; /* name=value */
    std::optional<search_range> bisect;
    std::string out; /* empty: standard output */
    std::string scenario;
};

extern const char *const help_text;

/* false: error is one line. */
bool parse_options(int argc, char **argv, options &result, std::string &error);

} // namespace coptersim_run

#endif
