// Life, errors, snapshots' owner and the default simulation of csim.h.
#include "api.h"

#include <mutex>

namespace coptersim {

namespace {

constexpr int kMostThreads = 64;

int check_options(const csim_options &options, const HotLoops **loops) {
    if (options.size != sizeof(csim_options))
        return fail(CSIM_E_ARG, "csim_new: options->size is not sizeof(csim_options), use "
                                "CSIM_OPTIONS_INIT");
    if (options.threads < 1 || options.threads > kMostThreads)
        return fail(CSIM_E_ARG, "csim_new: %d threads, 1..%d are possible", options.threads,
                    kMostThreads);
    *loops = find_hot_loops(options.build);
    if (*loops == nullptr)
        return fail(CSIM_E_ARG, "csim_new: this machine cannot run the build \"%.20s\"",
                    options.build);
    return CSIM_OK;
}

csim *new_simulation(const csim_options &options) {
    csim *sim = nullptr;
    const HotLoops *loops = nullptr;
    guarded("csim_new", [&] {
        const int code = check_options(options, &loops);
        if (code == CSIM_OK)
            sim = new csim(options, *loops);
        return code;
    });
    return sim;
}

csim *default_simulation() {
    static csim *const simulation = [] {
        csim_options options = CSIM_OPTIONS_INIT;
        options.faults = fc_default();
        return new_simulation(options);
    }();
    return simulation;
}

// Set once csim_default has been called, so that csim_free needs not make one.
csim *known_default;

} // namespace

int fail_null(const char *function, const char *argument) {
    return fail(CSIM_E_ARG, "%s: %s is NULL", function, argument);
}

int find_copter(const csim *sim, std::int32_t copter, const char *function, std::size_t *index) {
    if (sim == nullptr)
        return fail_null(function, "sim");
    const std::ptrdiff_t found = sim->world.copters.find(copter);
    if (found < 0)
        return fail(CSIM_E_ID, "%s: there is no copter %d", function, copter);
    *index = static_cast<std::size_t>(found);
    return CSIM_OK;
}

bool is_coordinate(double value) {
    return value >= -kFarthest && value <= kFarthest;
}

} // namespace coptersim

using namespace coptersim;

extern "C" {

const char *csim_error_name(int code) {
    switch (code) {
    case CSIM_OK:
        return "CSIM_OK";
    case CSIM_E_ARG:
        return "CSIM_E_ARG";
    case CSIM_E_NOMEM:
        return "CSIM_E_NOMEM";
    case CSIM_E_ID:
        return "CSIM_E_ID";
    case CSIM_E_NAME:
        return "CSIM_E_NAME";
    case CSIM_E_SPACE:
        return "CSIM_E_SPACE";
    case CSIM_E_HALTED:
        return "CSIM_E_HALTED";
    case CSIM_E_SNAPSHOT:
        return "CSIM_E_SNAPSHOT";
    default:
        return "CSIM_E_UNKNOWN";
    }
}

const char *csim_last_error_text(void) {
    return last_failure();
}

const char *csim_build_at(int index) {
    const HotLoops *loops = hot_loops_at(index);
    return loops != nullptr ? loops->name : nullptr;
}

csim *csim_new(const csim_options *options) {
    const csim_options defaults = CSIM_OPTIONS_INIT;
    return new_simulation(options != nullptr ? *options : defaults);
}

void csim_free(csim *sim) {
    if (sim != known_default)
        delete sim;
}

csim *csim_default(void) {
    return known_default = default_simulation();
}

fc_context *csim_faults(csim *sim) {
    return sim != nullptr ? sim->faults : nullptr;
}

int csim_reset(csim *sim) {
    if (sim == nullptr)
        return fail_null("csim_reset", "sim");
    if (sim->owns_faults)
        fc_reset(sim->faults);
    sim->world = World();
    sim->renewed = true;
    return CSIM_OK;
}

} // extern "C"
