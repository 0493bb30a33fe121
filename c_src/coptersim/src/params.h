// The table of parameters, by name. docs/coptersim.md explains each one.
#pragma once

#include "csim.h"

#include <cstdint>

namespace coptersim {

enum Integrator { kClosedForm, kExact, kEuler };
enum Gate { kGateOriginal, kGateMedian, kGateNeverAccept, kGateMajority };
enum Protect { kProtectNone, kProtectCrc, kProtectE2E };

// Values as csim_get gives them: switches 0 and 1, choices their number.
struct Params {
    // world and dynamics
    double altitude = 0.5;
    double integrator = kClosedForm;
    double drag = 0.9;
    double drag_linear = 0;
    double max_speed = 0;
    double tilt_cutoff = 180;
    double copter_radius = 0.4;
    double halt_on_collision = 1;
    // localisation
    double gate = kGateOriginal;
    double gate_error = 0.2;
    double gate_count = 3;
    double limit_pos = 0.2;
    double limit_vel = 1;
    double limit_acc = 1;
    // local dynamic map and risk
    double expiry_us = 1000000;
    double comfort_radius = 0.45;
    double comfort_error_gain = 0;
    double base_radius = 1;
    double speed_factor = 0.15;
    double cross_factor = 0.2;
    double length_divisor = 1.5;
    double risk_age_gain = 0;
    double brake_gain = 0;
    double brake_accel = 4.5;
    double copter_weight = 2;
    double line_weight = 3.5;
    double override_gain = 0.2;
    // messages
    double plausibility = 0;
    double plausible_speed = 15;
    double plausible_jump = 2;
    double silence_us = 0;
    double state_guard = 0;
    double protect = kProtectNone;
    // Those of copters added from now on.
    csim_gains gains{0.8, 0, 0, 2, 0, 0, 0, 0, 0, 0.5, 6};

    std::uint64_t expiry() const {
        return static_cast<std::uint64_t>(expiry_us);
    }
};

// One row of the table: a member of Params, or one of the gains.
struct ParamRow {
    csim_param info;
    double Params::*value;
    double csim_gains::*gain;
};

int param_count();
const ParamRow &param_row(int index);
// nullptr when there is none of that name (or it is NULL).
const ParamRow *find_param(const char *name);

// CSIM_OK, or CSIM_E_ARG with the text why.
int check_param(const ParamRow &row, double value);
// Reads a number, true or false, or the name of a choice.
int read_param(const ParamRow &row, const char *text, double *value);

int check_gains(const csim_gains &gains);

// A named set of values.
struct Setting {
    const char *name;
    double value;
};
struct Configuration {
    const char *name;
    const Setting *settings;
    int count;
};
// nullptr when there is none of that name; index beyond the last: nullptr.
const Configuration *find_configuration(const char *name);
const Configuration *configuration_at(int index);

} // namespace coptersim
