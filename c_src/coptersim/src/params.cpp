#include "params.h"

#include "failure.h"

#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

namespace coptersim {

namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr Params kInitial;

const char *const kIntegrators[] = {"v1", "exact", "euler"};
const char *const kGates[] = {"original", "median", "never-accept", "majority"};
const char *const kProtections[] = {"none", "crc", "e2e"};

constexpr ParamRow real(const char *name, double Params::*value, double min, double max,
                        const char *unit, const char *text) {
    return {{name, CSIM_REAL, min, max, kInitial.*value, unit, text, nullptr}, value, nullptr};
}
constexpr ParamRow onoff(const char *name, double Params::*value, const char *text) {
    return {{name, CSIM_SWITCH, 0, 1, kInitial.*value, "1", text, nullptr}, value, nullptr};
}
template <int count>
constexpr ParamRow choice(const char *name, double Params::*value,
                          const char *const (&names)[count], const char *text) {
    return {{name, CSIM_CHOICE, 0, count - 1, kInitial.*value, "1", text, names}, value, nullptr};
}
constexpr ParamRow gain(const char *name, double csim_gains::*value, double max, const char *unit,
                        const char *text) {
    return {{name, CSIM_REAL, 0, max, kInitial.gains.*value, unit, text, nullptr}, nullptr, value};
}

const ParamRow kTable[] = {
    real("altitude", &Params::altitude, 0, 1000, "m", "height that all copters keep"),
    choice("integrator", &Params::integrator, kIntegrators, "how positions are advanced"),
    real("drag", &Params::drag, 1e-6, 1, "1", "part of the velocity left after a second"),
    real("drag_linear", &Params::drag_linear, 0, 100, "m/s^2", "deceleration towards rest"),
    real("max_speed", &Params::max_speed, 0, 1e6, "m/s", "limit of the speed; 0: none"),
    real("tilt_cutoff", &Params::tilt_cutoff, 0, 180, "deg",
         "beyond this roll or pitch the velocity is zeroed; 180: never"),
    real("copter_radius", &Params::copter_radius, 0, 100, "m", "two copters collide at twice this"),
    onoff("halt_on_collision", &Params::halt_on_collision, "a run ends with its first collision"),
    choice("gate", &Params::gate, kGates, "what is done with range samples that do not fit"),
    real("gate_error", &Params::gate_error, 0, kInf, "m", "range error above which it gates"),
    real("gate_count", &Params::gate_count, 1, 1000000, "1",
         "misfits in a row that the original gate follows"),
    real("limit_pos", &Params::limit_pos, 0, kInf, "m", "limit of the integral part of position"),
    real("limit_vel", &Params::limit_vel, 0, kInf, "m/s", "limit of the integral part of velocity"),
    real("limit_acc", &Params::limit_acc, 0, kInf, "deg", "limit of the integral part of tilt"),
    real("expiry_us", &Params::expiry_us, 0, 1e12, "us", "age at which an entry is forgotten"),
    real("comfort_radius", &Params::comfort_radius, 0, 100, "m", "radius of the own comfort zone"),
    real("comfort_error_gain", &Params::comfort_error_gain, 0, 100, "1",
         "growth of the comfort radius with the recent range error"),
    real("base_radius", &Params::base_radius, 0, 100, "m", "radius of a risk ellipse at rest"),
    real("speed_factor", &Params::speed_factor, 0, 100, "s^2/m",
         "growth of the ellipse, and shift of its centre, with speed^2"),
    real("cross_factor", &Params::cross_factor, 0, 100, "1",
         "growth across the speed, as part of that along it"),
    real("length_divisor", &Params::length_divisor, 1e-3, kInf, "1",
         "length of a line / this is added to its semi-axis"),
    real("risk_age_gain", &Params::risk_age_gain, 0, 100, "m/s",
         "growth of a copter's ellipse with the age of its message"),
    real("brake_gain", &Params::brake_gain, 0, 100, "1",
         "growth of an ellipse, as part of the way needed to brake"),
    real("brake_accel", &Params::brake_accel, 0.01, 1000, "m/s^2", "deceleration when braking"),
    real("copter_weight", &Params::copter_weight, 0, 1e6, "1", "M of copters is this / q"),
    real("line_weight", &Params::line_weight, 0, 1e6, "1", "M of lines"),
    real("override_gain", &Params::override_gain, 0, 1e6, "1",
         "from the sum of risks to a command"),
    onoff("plausibility", &Params::plausibility, "discard messages that cannot be true"),
    real("plausible_speed", &Params::plausible_speed, 0, kInf, "m/s", "largest speed believed"),
    real("plausible_jump", &Params::plausible_jump, 0, kInf, "m",
         "largest deviation from the position expected"),
    real("silence_us", &Params::silence_us, 0, 1e12, "us",
         "a copter that has heard nobody for so long stops; 0: never"),
    real("state_guard", &Params::state_guard, 0, kInf, "m",
         "largest change of the perceived position that is not dead reckoning; 0: any"),
    choice("protect", &Params::protect, kProtections, "what guards the bytes of a message"),
    gain("pos_p", &csim_gains::pos_p, 1000, "1", "gain of the position, proportional"),
    gain("pos_i", &csim_gains::pos_i, 1000, "1/s", "gain of the position, integral"),
    gain("pos_d", &csim_gains::pos_d, 1000, "s", "gain of the position, derivative"),
    gain("vel_p", &csim_gains::vel_p, 1000, "1/s", "gain of the velocity, proportional"),
    gain("vel_i", &csim_gains::vel_i, 1000, "1/s^2", "gain of the velocity, integral"),
    gain("vel_d", &csim_gains::vel_d, 1000, "1", "gain of the velocity, derivative"),
    gain("acc_p", &csim_gains::acc_p, 1000, "deg/m", "gain of the tilt, proportional"),
    gain("acc_i", &csim_gains::acc_i, 1000, "deg/(m s)", "gain of the tilt, integral"),
    gain("acc_d", &csim_gains::acc_d, 1000, "deg s/m", "gain of the tilt, derivative"),
    gain("max_corr", &csim_gains::max_corr, 1e9, "m", "largest range error used"),
    gain("max_tilt", &csim_gains::max_tilt, 90, "deg", "largest tilt estimate"),
};
constexpr int kCount = static_cast<int>(sizeof kTable / sizeof *kTable);

// Chosen by `make copter-campaign`; docs/copter.md has the figures. Messages every 50 ms belong to
// it, which is a matter of the run.
const Setting kHardened[] = {
    {"comfort_radius", 1.1}, {"base_radius", 1.5},   {"max_corr", 0.07},
    {"brake_gain", 2},       {"override_gain", 0.6}, {"silence_us", 300000},
};
const Configuration kConfigurations[] = {
    {"default", nullptr, 0},
    {"hardened", kHardened, static_cast<int>(sizeof kHardened / sizeof *kHardened)},
};

int refuse(const csim_param &info, const char *text) {
    return fail(CSIM_E_ARG, "parameter %s: \"%.40s\" is not a %s", info.name, text,
                info.kind == CSIM_SWITCH   ? "switch (true, false, 1, 0)"
                : info.kind == CSIM_CHOICE ? "choice of this parameter"
                                           : "number");
}

} // namespace

int param_count() {
    return kCount;
}

const ParamRow &param_row(int index) {
    return kTable[index];
}

const ParamRow *find_param(const char *name) {
    for (const ParamRow &row : kTable)
        if (name != nullptr && std::strcmp(row.info.name, name) == 0)
            return &row;
    return nullptr;
}

int check_param(const ParamRow &row, double value) {
    const csim_param &info = row.info;
    if (!(value >= info.min && value <= info.max))
        return fail(CSIM_E_ARG, "parameter %s: %g is outside %g..%g", info.name, value, info.min,
                    info.max);
    if (info.kind != CSIM_REAL && value != std::floor(value))
        return fail(CSIM_E_ARG, "parameter %s: %g is not a whole number", info.name, value);
    return CSIM_OK;
}

int read_param(const ParamRow &row, const char *text, double *value) {
    const csim_param &info = row.info;
    if (info.kind == CSIM_CHOICE)
        for (int i = 0; i <= static_cast<int>(info.max); ++i)
            if (std::strcmp(info.choices[i], text) == 0) {
                *value = i;
                return CSIM_OK;
            }
    if (info.kind == CSIM_SWITCH && (!std::strcmp(text, "true") || !std::strcmp(text, "false"))) {
        *value = text[0] == 't';
        return CSIM_OK;
    }
    double number = 0;
    const char *end = text + std::strlen(text);
    const std::from_chars_result read = std::from_chars(text, end, number);
    if (read.ec != std::errc() || read.ptr != end)
        return refuse(info, text);
    *value = number;
    return check_param(row, number);
}

int check_gains(const csim_gains &gains) {
    for (const ParamRow &row : kTable)
        if (row.gain != nullptr)
            if (const int code = check_param(row, gains.*row.gain))
                return code;
    return CSIM_OK;
}

const Configuration *find_configuration(const char *name) {
    for (const Configuration &known : kConfigurations)
        if (name != nullptr && std::strcmp(known.name, name) == 0)
            return &known;
    return nullptr;
}

const Configuration *configuration_at(int index) {
    const int count = static_cast<int>(sizeof kConfigurations / sizeof *kConfigurations);
    return index >= 0 && index < count ? &kConfigurations[index] : nullptr;
}

} // namespace coptersim
