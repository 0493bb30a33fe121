// One thread or several: the same bits, and no race.
#include "check.h"
#include "random_world.h"

namespace {

constexpr int kPieces = 5; // of the world: the thread sanitizer is slow

void keep_quiet(void *, const fc_error *) {}

std::uint64_t run(const RandomWorld &world, int threads) {
    csim_options options = CSIM_OPTIONS_INIT;
    options.threads = threads;
    csim *sim = csim_new(&options);
    fc_set_error_callback(csim_faults(sim), keep_quiet, nullptr);
    world.build(sim);
    for (int at = 0; at < kPieces; ++at)
        world.run_piece(sim, at, 1000);
    const std::uint64_t digest = RandomWorld::digest(sim);
    csim_free(sim);
    return digest;
}

} // namespace

int main() {
    WorldOptions options;
    options.copters = 70;
    options.its_always_rare = true;
    const RandomWorld world(2000, options);
    CHECK(run(world, 1) == run(world, 2));
    options.copters = 100;
    const RandomWorld larger(2001, options);
    CHECK(run(larger, 1) == run(larger, 3));
    return CHECK_RESULT();
}
