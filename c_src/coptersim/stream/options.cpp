/* options.cpp: reads the command line. */
#include "options.hpp"

#include "command_line.hpp"
#include "publisher.hpp"

#include <cmath>

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

using coptersim_run::read_number;
using coptersim_run::wrong;

namespace {

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
    coptersim_run::command_line line;
    line.program = "coptersim_stream";
    line.with_value = {"--lcm-url", "--log", "--speed", "--observer", "--set"};
    line.take = [&result](const std::string &name, const std::string &value, std::string &why) {
        return take(name, value, result, why);
    };
    line.take_flag = [&result](const std::string &name) { return take_flag(name, result); };
    return read_words(line, argc, argv, result.scenario, error) &&
           (result.help || check_together(result, error));
}

} // namespace coptersim_stream
