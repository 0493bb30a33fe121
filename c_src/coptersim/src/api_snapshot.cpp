// Snapshots of csim.h.
#include "api.h"

#include <memory>

using namespace coptersim;

struct csim_snapshot {
    std::shared_ptr<const char> owner; // csim::identity
    World world;
    fc_snapshot *faults;

    ~csim_snapshot() {
        fc_release(faults);
    }
};

extern "C" {

csim_snapshot *csim_save(const csim *sim) {
    if (sim == nullptr || !sim->owns_faults) {
        fail(CSIM_E_ARG, "csim_save: %s",
             sim == nullptr ? "sim is NULL" : "the fault context belongs to someone else");
        return nullptr;
    }
    csim_snapshot *snapshot = nullptr;
    guarded("csim_save", [&] {
        std::unique_ptr<csim_snapshot> made(new csim_snapshot{sim->identity, sim->world, nullptr});
        made->faults = fc_save(sim->faults);
        if (made->faults == nullptr)
            throw std::bad_alloc();
        snapshot = made.release();
        return CSIM_OK;
    });
    return snapshot;
}

int csim_restore(csim *sim, const csim_snapshot *snapshot) {
    if (sim == nullptr || snapshot == nullptr)
        return fail_null("csim_restore", sim == nullptr ? "sim" : "snapshot");
    if (snapshot->owner != sim->identity)
        return fail(CSIM_E_SNAPSHOT, "csim_restore: the snapshot belongs to another simulation");
    return guarded("csim_restore", [&] {
        World world = snapshot->world;
        if (fc_restore(sim->faults, snapshot->faults) != FC_OK)
            throw std::bad_alloc();
        std::swap(sim->world, world);
        sim->renewed = true;
        return CSIM_OK;
    });
}

void csim_release(csim_snapshot *snapshot) {
    delete snapshot;
}

} // extern "C"
