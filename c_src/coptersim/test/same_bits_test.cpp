// The same world gives the same bits however it is run. Worlds are drawn from seeds; argument: how
// many.
#include "check.h"
#include "random_world.h"

#include <cstdlib>
#include <memory>

namespace {

struct Free {
    void operator()(csim *sim) const {
        csim_free(sim);
    }
    void operator()(csim_snapshot *snapshot) const {
        csim_release(snapshot);
    }
};
using Simulation = std::unique_ptr<csim, Free>;
using Snapshot = std::unique_ptr<csim_snapshot, Free>;

void keep_quiet(void *, const fc_error *) {}

Simulation make(bool brute_force = false, const char *build = nullptr) {
    csim_options options = CSIM_OPTIONS_INIT;
    options.brute_force = brute_force;
    options.build = build;
    Simulation sim(csim_new(&options));
    fc_set_error_callback(csim_faults(sim.get()), keep_quiet, nullptr);
    return sim;
}

bool same(std::uint64_t seed, const char *way, std::uint64_t expected, std::uint64_t got) {
    if (expected != got)
        std::fprintf(stderr, "seed %llu: %s gives other bits\n",
                     static_cast<unsigned long long>(seed), way);
    return expected == got;
}

// Saves in the middle, runs on, restores twice and runs on again.
std::uint64_t run_restored(const RandomWorld &world, int from) {
    const Simulation sim = make();
    world.build(sim.get());
    for (int at = 0; at < from; ++at)
        world.run_piece(sim.get(), at, 1000);
    const Snapshot snapshot(csim_save(sim.get()));
    for (int round = 0; round < 2; ++round) {
        const int end = round == 0 ? from + 5 : RandomWorld::kPieces;
        for (int at = from; at < end; ++at)
            world.run_piece(sim.get(), at, 1000);
        if (round == 0)
            CHECK_INT(csim_restore(sim.get(), snapshot.get()), CSIM_OK);
    }
    return RandomWorld::digest(sim.get());
}

void check_world(std::uint64_t seed, int copters) {
    WorldOptions options;
    options.copters = copters;
    const RandomWorld world(seed, options);
    const std::uint64_t expected = world.run(make().get());
    CHECK(same(seed, "a second run", expected, world.run(make().get())));
    CHECK(same(seed, "testing all pairs", expected, world.run(make(true).get())));
    CHECK(same(seed, "steps one by one", expected, world.run(make().get(), 1)));
    CHECK(same(seed, "runs of 7 steps", expected, world.run(make().get(), 7)));
    CHECK(same(seed, "a restored snapshot", expected, run_restored(world, 7)));
    const Simulation again = make();
    world.run(again.get());
    CHECK_INT(csim_reset(again.get()), CSIM_OK);
    CHECK(same(seed, "a simulation that was reset", expected, world.run(again.get())));
    for (int i = 0; const char *build = csim_build_at(i); ++i)
        CHECK(same(seed, build, expected, world.run(make(false, build).get())));
}

// Without faults, whose random streams depend on names, ids matter by their order alone.
void check_ids(std::uint64_t seed) {
    WorldOptions options, others;
    options.faults = others.faults = false;
    others.id_step = 17;
    others.id_first = 1000000;
    CHECK(same(seed, "other ids in the same order", RandomWorld(seed, options).run(make().get()),
               RandomWorld(seed, others).run(make().get())));
}

} // namespace

int main(int argc, char **argv) {
    const int worlds = argc > 1 ? std::atoi(argv[1]) : 20;
    for (int seed = 1; seed <= worlds; ++seed) {
        check_world(static_cast<std::uint64_t>(seed), 2 + seed % 13);
        check_ids(static_cast<std::uint64_t>(seed));
    }
    return CHECK_RESULT();
}
