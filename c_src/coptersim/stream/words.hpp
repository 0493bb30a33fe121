/* words.hpp: events of a scenario in words: name and arguments of a command, parameters of a fault
 * as JSON. */
#ifndef CSIM_STREAM_WORDS_HPP
#define CSIM_STREAM_WORDS_HPP

#include "scenario.hpp"

#include <string>

namespace coptersim_stream {

struct words {
    std::string name; /* the type of the event */
    std::string args; /* as Erlang terms, separated by commas */

    std::string text() const {
        return name + "(" + args + ")";
    }
};
words words_of(const csim_scenario::event &e);

/* A JSON object: the parameters by name, and when it acts, as in the scenario. */
std::string parameters_of(const csim_scenario::fault &f);

/* The shortest decimals that are the same number; whole numbers without a point. */
std::string number_text(double x);

} // namespace coptersim_stream

#endif
