/* options.cpp: reads the command line. */
#include "options.hpp"

#include "publisher.hpp"

#include <cmath>
#include <cstdlib>

namespace coptersim_stream {

const char *const help_text =
    R"(coptersim_stream: play a scenario of quadcopters as LCM messages, for the visualizer.

  coptersim_stream [OPTION]... SCENARIO.json        "-": standard input

  --lcm-url=URL         publish there; default udpm://239.255.76.67:7667?ttl=0&recv_buf_size=2097152
                        unless there is --log
  --log FILE            write an LCM log, with simulated times; the same scenario gives the same bytes
  --speed X             of publishing: 2 is twice as fast, 0 does not wait; default 1
  --observer ID         the copter whose risk contours and ranges are told; default the first that
                        meets a fault, or the first
  --set NAME=VALUE      in place of what the scenario says, as coptersim_run takes it; repeatable
  --allow-network       let packets leave this host: a ttl above 0, a route that is not loopback
  --help

Messages: the folder lcm and docs/visualizer.md. liblcm takes the kernel's route for the group, so
publishing needs, once and as root: ip route replace 239.255.76.67/32 dev lo src 127.0.0.1
Exit status: 0 done, also after a collision; 2 wrong command line or scenario, no route, or the log
cannot be written; 130 interrupted, without a log.
)";

namespace {

bool wrong(std::string &error, const std::string &option, const std::string &expected) {
    error = option + ": " + expected + " expected";
    return false;
}

bool read_number(const std::string &text, double low, double high, double &number) {
    char *end = nullptr;
    number = std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0' && number >= low && number <= high;
}

bool has_value(const std::string &name) {
    for (const char *known : {"--lcm-url", "--log", "--speed", "--observer", "--set"}) {
        if (name == known) {
            return true;
        }
    }
    return false;
}

bool take(const std::string &name, const std::string &value, options &o, std::string &error) {
    double number = 0;
    if (name == "--lcm-url") {
        o.url = value;
        multicast_place place;
        return read_url(value, true, place, error);
    }
    if (name == "--log") {
        o.log = value;
        return !value.empty() || wrong(error, name, "a file");
    }
    if (name == "--set") {
        o.settings.push_back(value);
        return true;
    }
    if (name == "--speed") {
        bool good = value == "0" || read_number(value, 0.05, 1000, o.speed);
        o.speed = value == "0" ? 0 : o.speed;
        return good || wrong(error, name, "0 or a number from 0.05 to 1000");
    }
    bool whole = read_number(value, 0, INT32_MAX, number) && number == std::floor(number);
    if (whole) {
        o.observer = static_cast<std::int32_t>(number);
    }
    return whole || wrong(error, name, "the id of a copter");
}

bool take_flag(const std::string &name, options &o) {
    o.help = o.help || name == "--help" || name == "-h";
    o.allow_network = o.allow_network || name == "--allow-network";
    return name == "--help" || name == "-h" || name == "--allow-network";
}

bool check_together(options &o, std::string &error) {
    if (o.scenario.empty()) {
        error = "a scenario expected; see coptersim_stream --help";
        return false;
    }
    if (o.url.empty() && o.log.empty()) {
        o.url = default_url;
    }
    multicast_place place;
    return o.url.empty() || read_url(o.url, o.allow_network, place, error);
}

} // namespace

bool parse_options(int argc, char **argv, options &result, std::string &error) {
    for (int i = 1; i < argc; i++) {
        std::string word = argv[i];
        std::size_t equals = word.find('=');
        std::string name = word.substr(0, equals);
        if (word.size() < 2 || word[0] != '-') {
            if (!result.scenario.empty()) {
                error = "one scenario expected, not also \"" + word + "\"";
                return false;
            }
            result.scenario = word;
        } else if (has_value(name)) {
            bool inside = equals != std::string::npos;
            if (!inside && i + 1 == argc) {
                return wrong(error, name, "a value");
            }
            if (!take(name, inside ? word.substr(equals + 1) : argv[++i], result, error)) {
                return false;
            }
        } else if (!take_flag(word, result)) {
            error = "unknown option " + word + "; see coptersim_stream --help";
            return false;
        }
    }
    return result.help || check_together(result, error);
}

} // namespace coptersim_stream
