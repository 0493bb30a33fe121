// What the functions of csim.h share: checks, and no exception over the border.
#pragma once

#include "failure.h"
#include "simulation.h"

#include <algorithm>
#include <new>
#include <system_error>
#include <vector>

namespace coptersim {

int fail_null(const char *function, const char *argument);

// CSIM_OK, or CSIM_E_ID with the text why; *index is where the copter is.
int find_copter(const csim *sim, std::int32_t copter, const char *function, std::size_t *index);

// Coordinates are finite and not absurd: within 1e9 m.
constexpr double kFarthest = 1e9;
bool is_coordinate(double value);

// Copies at most *count things out; CSIM_E_SPACE when there are more.
template <class Thing>
int copy_out(const std::vector<Thing> &things, Thing *list, std::size_t *count,
             const char *function) {
    const std::size_t room = list != nullptr ? *count : 0;
    *count = things.size();
    if (list == nullptr)
        return CSIM_OK;
    std::copy_n(things.begin(), std::min(room, things.size()), list);
    return room >= things.size() ? CSIM_OK
                                 : fail(CSIM_E_SPACE, "%s: there are %zu, room for %zu", function,
                                        things.size(), room);
}

template <class Work> int guarded(const char *function, const Work &work) {
    try {
        return work();
    } catch (const std::bad_alloc &) {
        return fail(CSIM_E_NOMEM, "%s: out of memory", function);
    } catch (const std::system_error &) {
        return fail(CSIM_E_NOMEM, "%s: no thread could be started", function);
    }
}

} // namespace coptersim
