// Parameters and gains of csim.h.
#include "api.h"

#include <cstring>

using namespace coptersim;

namespace {

int find_row(const csim *sim, const char *name, const char *function, const ParamRow **row) {
    if (sim == nullptr || name == nullptr)
        return fail_null(function, sim == nullptr ? "sim" : "name");
    *row = find_param(name);
    return *row != nullptr
               ? CSIM_OK
               : fail(CSIM_E_NAME, "%s: there is no parameter \"%.40s\"", function, name);
}

// A gain is set for all copters.
void assign(csim *sim, const ParamRow &row, double value) {
    World &world = sim->world;
    if (row.value != nullptr) {
        world.params.*row.value = value;
    } else {
        world.params.gains.*row.gain = value;
        for (csim_gains &gains : world.copters.gains)
            gains.*row.gain = value;
    }
    sim->lists_stale = true;
}

} // namespace

extern "C" {

int csim_param_count(void) {
    return param_count();
}

const csim_param *csim_param_at(int index) {
    return index >= 0 && index < param_count() ? &param_row(index).info : nullptr;
}

int csim_set(csim *sim, const char *name, double value) {
    const ParamRow *row = nullptr;
    int code = find_row(sim, name, "csim_set", &row);
    if (code == CSIM_OK)
        code = check_param(*row, value);
    if (code == CSIM_OK)
        assign(sim, *row, value);
    return code;
}

int csim_get(const csim *sim, const char *name, double *value) {
    const ParamRow *row = nullptr;
    if (const int code = find_row(sim, name, "csim_get", &row))
        return code;
    if (value == nullptr)
        return fail_null("csim_get", "value");
    const Params &params = sim->world.params;
    *value = row->value != nullptr ? params.*row->value : params.gains.*row->gain;
    return CSIM_OK;
}

int csim_set_text(csim *sim, const char *name, const char *text) {
    const ParamRow *row = nullptr;
    double value = 0;
    int code = find_row(sim, name, "csim_set_text", &row);
    if (code == CSIM_OK)
        code =
            text == nullptr ? fail_null("csim_set_text", "text") : read_param(*row, text, &value);
    if (code == CSIM_OK)
        assign(sim, *row, value);
    return code;
}

const char *csim_configuration_at(int index) {
    const Configuration *configuration = configuration_at(index);
    return configuration != nullptr ? configuration->name : nullptr;
}

int csim_configure(csim *sim, const char *name) {
    if (sim == nullptr || name == nullptr)
        return fail_null("csim_configure", sim == nullptr ? "sim" : "name");
    const Configuration *configuration = find_configuration(name);
    if (configuration == nullptr)
        return fail(CSIM_E_NAME, "csim_configure: there is no configuration \"%.40s\"", name);
    for (int i = 0; i < param_count(); ++i)
        assign(sim, param_row(i), param_row(i).info.initial);
    for (int i = 0; i < configuration->count; ++i)
        assign(sim, *find_param(configuration->settings[i].name), configuration->settings[i].value);
    return CSIM_OK;
}

int csim_set_gains(csim *sim, int32_t copter, const csim_gains *gains) {
    std::size_t i = 0;
    int code = find_copter(sim, copter, "csim_set_gains", &i);
    if (code == CSIM_OK)
        code = gains == nullptr ? fail_null("csim_set_gains", "gains") : check_gains(*gains);
    if (code != CSIM_OK)
        return code;
    sim->world.copters.gains[i] = *gains;
    sim->lists_stale = true;
    return CSIM_OK;
}

int csim_set_gains_all(csim *sim, const csim_gains *gains) {
    if (sim == nullptr || gains == nullptr)
        return fail_null("csim_set_gains_all", sim == nullptr ? "sim" : "gains");
    if (const int code = check_gains(*gains))
        return code;
    sim->world.params.gains = *gains;
    for (csim_gains &own : sim->world.copters.gains)
        own = *gains;
    sim->lists_stale = true;
    return CSIM_OK;
}

int csim_get_gains(const csim *sim, int32_t copter, csim_gains *gains) {
    std::size_t i = 0;
    if (const int code = find_copter(sim, copter, "csim_get_gains", &i))
        return code;
    if (gains == nullptr)
        return fail_null("csim_get_gains", "gains");
    *gains = sim->world.copters.gains[i];
    return CSIM_OK;
}

} // extern "C"
