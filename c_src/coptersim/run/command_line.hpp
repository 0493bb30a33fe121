/* command_line.hpp: reads the command line of a program that takes options and one scenario. */
#ifndef CSIM_RUN_COMMAND_LINE_HPP
#define CSIM_RUN_COMMAND_LINE_HPP

#include <functional>
#include <string>
#include <vector>

namespace coptersim_run {

struct command_line {
    std::string program;                 /* for errors */
    std::vector<std::string> with_value; /* options that take one: --name=VALUE or --name VALUE */
    /* One of them, with its value; false: error is one line. */
    std::function<bool(const std::string &name, const std::string &value, std::string &error)> take;
    /* Any other option; false: there is none of this name. */
    std::function<bool(const std::string &name)> take_flag;
};

/* Takes every word; scenario stays empty when there is none ("-" is one). false: error is one line.
 */
bool read_words(const command_line &line, int argc, char **argv, std::string &scenario,
                std::string &error);

/* The whole text as a number from low to high. */
bool read_number(const std::string &text, double low, double high, double &number);

/* Writes "option: expected expected"; always false. */
bool wrong(std::string &error, const std::string &option, const std::string &expected);

} // namespace coptersim_run

#endif
