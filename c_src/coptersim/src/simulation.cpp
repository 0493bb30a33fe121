#include "simulation.h"

#include <new>

namespace coptersim {

namespace {

// Faults see the start of the step, as events do.
std::int64_t simulated_time(void *user) {
    return static_cast<std::int64_t>(static_cast<const csim *>(user)->world.time_us * 1000);
}

fc_context *new_context(std::uint64_t seed) {
    fc_options options = FC_OPTIONS_INIT;
    options.seed = seed;
    fc_context *context = fc_new(&options);
    if (context == nullptr)
        throw std::bad_alloc();
    return context;
}

} // namespace

} // namespace coptersim

csim::csim(const csim_options &options, const coptersim::HotLoops &loops)
    : faults(options.faults), owns_faults(options.faults == nullptr),
      brute_force(options.brute_force), hot(loops), pool(options.threads),
      identity(std::make_shared<char>()) {
    if (owns_faults)
        faults = coptersim::new_context(options.seed);
    fc_set_clock(faults, coptersim::simulated_time, this);
}

csim::~csim() {
    if (owns_faults)
        fc_free(faults);
    else
        fc_set_clock(faults, nullptr, nullptr);
}

void csim::prepare() {
    coptersim::Columns &copters = world.copters;
    const std::size_t count = copters.size();
    world.terrain.prepare(world.params.base_radius, world.params.length_divisor);
    if (renewed) {
        world.broadcasts.set_senders(copters.id);
        const std::size_t rows = world.broadcasts.now.size();
        risk.resize(count, rows, world.terrain.lines().size());
        risk_before.resize(count, rows, world.terrain.lines().size());
        contacts.resize(count);
        ax.assign(coptersim::padded(count), 0);
        ay.assign(coptersim::padded(count), 0);
        stamps.assign(count, 0);
        has_ranges.assign(count, 0);
        packet.resize(128);
        world.collisions.reserve(count);
        note_privates();
    } else if (lists_stale) {
        risk.drop_lists();
        risk_before.drop_lists();
        contacts.drop_lists();
    }
    lists_stale = false;
}

void csim::note_privates() {
    private_flags.assign(world.copters.size(), 0);
    for (const coptersim::PrivateMap &map : world.broadcasts.privates) {
        const std::ptrdiff_t i = world.copters.find(map.receiver);
        if (i >= 0)
            private_flags[static_cast<std::size_t>(i)] = 1;
    }
}
