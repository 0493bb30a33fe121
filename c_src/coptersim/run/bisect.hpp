/* bisect.hpp: the smallest value of a parameter with which a scenario has no collision. */
#ifndef CSIM_RUN_BISECT_HPP
#define CSIM_RUN_BISECT_HPP

#include "options.hpp"
#include "recorded_run.hpp"

#include <cstdio>
#include <optional>

namespace coptersim_run {

struct bisection {
    std::optional<double> smallest; /* without a collision; none in the range */
    std::optional<double> largest;  /* below it, with a collision; none when LOW is the smallest */
};

/* Tries 17 values from low to high in equal steps up to the first that survives, then halves the
 * step before it 10 times, or down to neighbours when only whole numbers make sense. Surviving
 * values below that lie between two tried ones are not found. A line per run to `to`. false:
 * error is one line. */
bool bisect(csim *sim, const csim_scenario::scenario &s, const search_range &range,
            const observer &o, std::FILE *to, bisection &result, std::string &error);

} // namespace coptersim_run

#endif
