/* parts.hpp: the parts of a scenario, read from members of the file. All throw located_error. */
#ifndef CSIM_PARTS_HPP
#define CSIM_PARTS_HPP

#include "members.hpp"
#include "scenario.hpp"

#include <string>

namespace csim_scenario {

/* The gains among the members asked; others are left to the caller. */
gains_change read_gains(members &m);
/* From an object that holds nothing else; an empty change when there is none. */
gains_change read_gains_object(const node *value, const std::string &where);

/* A parameter by name; throws when there is none, or when the value is not one of its values. A
 * switch may be 0 or 1, a choice its number. */
setting read_setting(const std::string &name, const node &value, const std::string &where);

/* The name of one of csim_configuration_at. */
std::string read_configuration(const node &value, const std::string &where);

copter read_copter(members &m);

/* Whether it is the name of a member of csim_gains. */
bool is_gain(const std::string &name);

/* The rest of an event that arms a fault, checked against what the library knows of faults; and of
 * one that clears faults. */
fault read_fault(members &m, bool of_channel, const std::string &where);
clear_faults read_clear_faults(members &m);

/* The event at events[index]. */
event read_event(const node &value, const std::string &where);

/* Arms a fault in a context at the simulated time now_us, for an event at t_us; a fault id, or an
 * FC_E_ code with fc_last_error_text. */
fc_fault_id arm_fault(fc_context *context, const fault &f, std::uint64_t t_us,
                      std::uint64_t now_us);

} // namespace csim_scenario

#endif
