/* trace.hpp: samples of a simulation over time, written in the format coptersim-trace/1 or as
 * lines of comma-separated values (docs/copter_scenarios.md). */
#ifndef CSIM_TRACE_HPP
#define CSIM_TRACE_HPP

#include "csim.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace csim_trace {

constexpr std::size_t quantity_count = 7;
extern const std::array<const char *, quantity_count> quantity_names; /* px py vx ... */

/* One copter. Its samples belong to the times from index `first` on; a copter that was away in
 * between has NaN there. */
struct series {
    std::size_t first = 0;
    std::array<std::vector<double>, quantity_count> true_state, perceived;
    std::vector<std::uint8_t> override_active;
    std::uint64_t override_steps = 0;
    double max_pos_error = 0; /* m */
};

struct trace {
    std::string name;
    std::uint64_t end_t_us = 0;
    std::optional<csim_collision> collision; /* the first one */
    std::vector<std::uint64_t> t_us;
    std::map<std::int32_t, series> copters;
};

class recorder {
  public:
    /* The simulation must outlive the recorder. */
    recorder(const csim *sim, std::string name);

    void sample();
    /* Before a copter goes: keeps what is known at its end. */
    void keep(std::int32_t id);
    /* After the run. */
    trace finish();

  private:
    const csim *sim_;
    trace trace_;
};

/* Takes the text piece by piece. */
using sink = std::function<void(std::string_view)>;

void write_json(const trace &t, const sink &out);
void write_csv(const trace &t, const sink &out);

/* The shortest decimal that reads back as the same double; null for infinities and NaN. */
void append_number(std::string &text, double value);

} // namespace csim_trace

#endif
