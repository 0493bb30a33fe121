/* fuzz_coptersim_stream.cpp: any bytes as a scenario that is told as LCM messages. What is accepted
 * and small is played for a few steps; each message is one that the code of lcm-gen reads, and
 * writes alike. */
#include "recorded_run.hpp"
#include "streamed_run.hpp"

#include "viz/frame.hpp"
#include "viz/ranges.hpp"
#include "viz/risk.hpp"
#include "viz/status.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace {

constexpr std::size_t most_copters = 20;
constexpr std::size_t most_lines = 50;
constexpr std::size_t most_events = 200;
constexpr std::uint64_t most_steps = 30;

void expect(bool good) {
    if (!good) {
        std::abort();
    }
}

template <class M> bool reads(const char *channel, const char *name, std::string_view bytes) {
    if (std::strcmp(channel, name) != 0) {
        return false;
    }
    M message;
    int size = static_cast<int>(bytes.size());
    expect(message.decode(bytes.data(), 0, size) == size);
    expect(coptersim_stream::encoded(message) == bytes);
    return true;
}

class reader : public coptersim_stream::sink {
  public:
    bool put(std::uint64_t, const char *channel, std::string_view bytes, std::string &) override {
        expect(reads<viz::frame>(channel, "VIZ_FRAME", bytes) ||
               reads<viz::risk>(channel, "VIZ_RISK", bytes) ||
               reads<viz::ranges>(channel, "VIZ_RANGE", bytes) ||
               reads<viz::event>(channel, "VIZ_EVENT", bytes) ||
               reads<viz::faults>(channel, "VIZ_FAULTS", bytes) ||
               reads<viz::world>(channel, "VIZ_WORLD", bytes) ||
               reads<viz::case_info>(channel, "VIZ_CASE", bytes) ||
               reads<viz::status>(channel, "VIZ_STATUS", bytes));
        return true;
    }
};

void tell(csim_scenario::scenario &s) {
    static const coptersim_run::sim_owner sim = coptersim_run::new_simulation(1);
    fc_set_error_callback(
        csim_faults(sim.get()), [](void *, const fc_error *) {}, nullptr);
    s.duration_us = std::min(s.duration_us, most_steps * s.dt_us);
    reader to;
    coptersim_stream::telling how;
    how.observer = coptersim_stream::default_observer(s);
    how.frame_us = coptersim_stream::frame_interval(s.dt_us, 1);
    coptersim_stream::outcome result;
    std::string error;
    bool good = coptersim_stream::streamed_run(sim.get(), s, {{&to, how}}, {}, result, error);
    expect(good || (!error.empty() && error.find('\n') == std::string::npos));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    csim_scenario::scenario s;
    std::string error;
    std::string_view text(reinterpret_cast<const char *>(data), size);
    if (csim_scenario::read_scenario(text, "f", s, error) && s.copters.size() <= most_copters &&
        s.lines.size() <= most_lines && s.anchors.size() <= most_lines &&
        s.events.size() <= most_events) {
        tell(s);
    }
    return 0;
}
