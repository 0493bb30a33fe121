/* options.cpp: reads the command line. */
#include "options.hpp"

#include "command_line.hpp"

#include <cmath>

namespace coptersim_run {

const char *const help_text =
    R"(coptersim_run: run a scenario of quadcopters and write what happened.

  coptersim_run [OPTION]... SCENARIO.json        "-": standard input

  --format json|csv     of the trace; default json
  --out FILE            write the trace there instead of to standard output
  --threads N           1 to 64; the result is the same; default 1
  --build NAME          of the inner loops, one that this machine has (sse2, avx2, ...); the result
                        is the same; default the fastest
  --set NAME=VALUE      in place of what the scenario says: a gain (pos_p, ...), a parameter,
                        configuration, dt_us, duration_us, its_div, anchor_div, seed or
                        record_every_us; repeatable
  --fail-on-collision   exit with status 3 after a collision
  --replay              also tell on standard error what happens, in real time
  --speed X             of a replay: 2 is twice as fast, 0 does not wait; default 1
  --part-ms N           of a replay: show it in parts of so many milliseconds; default 17
  --bisect NAME=LOW:HIGH
                        no trace: find the smallest value of NAME from LOW to HIGH without a
                        collision, and print every run
  --help

Formats: docs/copter_scenarios.md. Exit status: 0 done, also after a collision; 1 --bisect found no value;
2 wrong command line or scenario, or the trace cannot be written; 3 collision and
--fail-on-collision; 130 interrupted.
)";

namespace {

bool read_range(const std::string &text, search_range &range) {
    std::size_t equals = text.find('='), colon = text.find(':', equals + 1);
    if (equals == std::string::npos || equals == 0 || colon == std::string::npos) {
        return false;
    }
    range.name = text.substr(0, equals);
    return read_number(text.substr(equals + 1, colon - equals - 1), -1e300, 1e300, range.low) &&
           read_number(text.substr(colon + 1), -1e300, 1e300, range.high) && range.low < range.high;
}

/* An option with a value. */
bool take(const std::string &name, const std::string &value, options &o, std::string &error) {
    double number = 0;
    if (name == "--format") {
        o.csv = value == "csv";
        return value == "csv" || value == "json" || wrong(error, name, "json or csv");
    }
    if (name == "--out") {
        o.out = value;
        return !value.empty() || wrong(error, name, "a file");
    }
    if (name == "--set") {
        o.settings.push_back(value);
        return true;
    }
    if (name == "--build") {
        o.build = value;
        return !value.empty() || wrong(error, name, "a name");
    }
    if (name == "--threads") {
        bool good = read_number(value, 1, 64, number) && number == std::floor(number);
        o.threads = good ? static_cast<int>(number) : 1;
        return good || wrong(error, name, "a whole number from 1 to 64");
    }
    if (name == "--speed") {
        return read_number(value, 0, 1e6, o.speed) || wrong(error, name, "a number from 0 to 1e6");
    }
    if (name == "--part-ms") {
        return read_number(value, 0.001, 1e6, o.part_ms) ||
               wrong(error, name, "a number from 0.001 to 1e6");
    }
    search_range range;
    o.bisect = range;
    return read_range(value, *o.bisect) || wrong(error, name, "NAME=LOW:HIGH with LOW < HIGH");
}

bool take_flag(const std::string &name, options &o) {
    if (name == "--help" || name == "-h") {
        o.help = true;
    } else if (name == "--replay") {
        o.replay = true;
    } else if (name == "--fail-on-collision") {
        o.fail_on_collision = true;
    } else {
        return false;
    }
    return true;
}

} // namespace

bool parse_options(int argc, char **argv, options &result, std::string &error) {
    command_line line;
    line.program = "coptersim_run";
    line.with_value = {"--format", "--out",   "--set",     "--threads",
                       "--build",  "--speed", "--part-ms", "--bisect"};
    line.take = [&result](const std::string &name, const std::string &value, std::string &why) {
        return take(name, value, result, why);
    };
    line.take_flag = [&result](const std::string &name) { return take_flag(name, result); };
    if (!read_words(line, argc, argv, result.scenario, error)) {
        return false;
    }
    if (result.scenario.empty() && !result.help) {
        error = "a scenario expected; see coptersim_run --help";
        return false;
    }
    return true;
}

} // namespace coptersim_run
