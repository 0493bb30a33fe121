/* command_line.cpp: see command_line.hpp. */
#include "command_line.hpp"

#include <algorithm>
#include <cstdlib>

namespace coptersim_run {

bool read_number(const std::string &text, double low, double high, double &number) {
    char *end = nullptr;
    number = std::strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0' && number >= low && number <= high;
}

bool wrong(std::string &error, const std::string &option, const std::string &expected) {
    error = option + ": " + expected + " expected";
    return false;
}

bool read_words(const command_line &line, int argc, char **argv, std::string &scenario,
                std::string &error) {
    auto has_value = [&](const std::string &name) {
        return std::find(line.with_value.begin(), line.with_value.end(), name) !=
               line.with_value.end();
    };
    for (int i = 1; i < argc; i++) {
        std::string word = argv[i];
        std::size_t equals = word.find('=');
        std::string name = word.substr(0, equals);
        if (word.size() < 2 || word[0] != '-') {
            if (!scenario.empty()) {
                error = "one scenario expected, not also \"" + word + "\"";
                return false;
            }
            scenario = word;
        } else if (has_value(name)) {
            bool inside = equals != std::string::npos;
            if (!inside && i + 1 == argc) {
                return wrong(error, name, "a value");
            }
            if (!line.take(name, inside ? word.substr(equals + 1) : argv[++i], error)) {
                return false;
            }
        } else if (!line.take_flag(word)) {
            error = "unknown option " + word + "; see " + line.program + " --help";
            return false;
        }
    }
    return true;
}

} // namespace coptersim_run
