/* output.hpp: writes a trace where the command line says, whole or not at all. */
#ifndef CSIM_RUN_OUTPUT_HPP
#define CSIM_RUN_OUTPUT_HPP

#include "trace.hpp"

#include <string>

namespace coptersim_run {

/* file empty: standard output. A file gets its name when it is complete. false: error is one
 * line. */
bool write_trace(const csim_trace::trace &t, bool csv, const std::string &file, std::string &error);

} // namespace coptersim_run

#endif
