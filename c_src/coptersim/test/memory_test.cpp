// Steps after the first broadcast allocate nothing while no channel fault is armed.
#include "check.h"
#include "csim.h"
#include "fc.h"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

std::atomic<bool> counting{false};
std::atomic<long> allocations{0};

void *allocate(std::size_t size, std::size_t alignment) {
    if (counting)
        ++allocations;
    void *memory =
        alignment == 0
            ? std::malloc(size)
            : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
    if (memory == nullptr)
        throw std::bad_alloc();
    return memory;
}

} // namespace

// Both libraries allocate by these.
void *operator new(std::size_t size) {
    return allocate(size, 0);
}
void *operator new(std::size_t size, std::align_val_t alignment) {
    return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void *memory) noexcept {
    std::free(memory);
}
void operator delete(void *memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void *memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void *memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace {

// What happens between csim_run and its first step is not part of a step: it is counted from the
// second step on.
int start_counting(void *, csim *) {
    counting = true;
    return 0;
}

void steps_do_not_allocate(int copters, bool probes) {
    csim *sim = csim_new(nullptr);
    csim_set(sim, "halt_on_collision", 0);
    for (int i = 0; i < 4; i++) {
        csim_add_anchor(sim, i, i < 2 ? -9 : 90, i % 2 ? -9 : 90, 2);
        csim_add_line(sim, i, i < 2 ? -9 : 90, -9, i < 2 ? -9 : 90, 90);
    }
    for (int i = 0; i < copters; i++) {
        csim_add_copter(sim, i, 2.5 * (i % 20), 2.5 * (i / 20), i);
        csim_command(sim, i, i % 3 * 0.3 - 0.3, i % 5 * 0.2 - 0.4, 0.3, 0);
    }
    if (probes) {
        fc_add_offset(csim_faults(sim), "RollId1", 1);
        fc_add_noise_gauss(csim_faults(sim), "RangeId1Anch2", 1);
    }
    csim_run(sim, 20, 5000, 20, 20);
    csim_on_step(sim, start_counting, nullptr);
    csim_run(sim, 400, 5000, 20, 20);
    counting = false;
    CHECK_INT(allocations.exchange(0), 0);
    csim_free(sim);
}

} // namespace

int main() {
    steps_do_not_allocate(4, false);
    steps_do_not_allocate(150, false);
    steps_do_not_allocate(150, true);
    return CHECK_RESULT();
}
