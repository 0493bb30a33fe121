/* names.cpp: gains and members of states by name. */
#include "parts.hpp"

#include <algorithm>

namespace csim_scenario {

const std::array<gain_name, gain_count> gain_names = {{
    {"pos_p", &csim_gains::pos_p},
    {"pos_i", &csim_gains::pos_i},
    {"pos_d", &csim_gains::pos_d},
    {"vel_p", &csim_gains::vel_p},
    {"vel_i", &csim_gains::vel_i},
    {"vel_d", &csim_gains::vel_d},
    {"acc_p", &csim_gains::acc_p},
    {"acc_i", &csim_gains::acc_i},
    {"acc_d", &csim_gains::acc_d},
    {"max_corr", &csim_gains::max_corr},
    {"max_tilt", &csim_gains::max_tilt},
}};

const std::array<state_name, set_state::count> state_names = {{
    {"px", &csim_state::px},
    {"py", &csim_state::py},
    {"pz", &csim_state::pz},
    {"vx", &csim_state::vx},
    {"vy", &csim_state::vy},
    {"roll", &csim_state::roll},
    {"pitch", &csim_state::pitch},
    {"yaw", &csim_state::yaw},
    {"e_r", &csim_state::e_r},
    {"e_p", &csim_state::e_p},
}};

bool is_gain(const std::string &name) {
    return std::any_of(gain_names.begin(), gain_names.end(),
                       [&name](const gain_name &gain) { return name == gain.name; });
}

bool gains_change::empty() const {
    for (const std::optional<double> &value : values) {
        if (value) {
            return false;
        }
    }
    return true;
}

void gains_change::apply(csim_gains &gains) const {
    for (std::size_t i = 0; i < gain_count; i++) {
        if (values[i]) {
            gains.*gain_names[i].member = *values[i];
        }
    }
}

} // namespace csim_scenario
