// faultcheck_wrapper.h over the default context.
#include "faultcheck_wrapper.h"

#include "arming.h"
#include "probe_call.h"

namespace {

using fc::TriggerChange;

constexpr int kHighestBit = 63;

void change_latest(const char *id, const TriggerChange &change) {
    fc::change_latest_trigger(*fc_default(), fc::Space::probes, id, change);
}

} // namespace

extern "C" {

void faultcheck_addFaultBitFlip(const char *identifier, int bitToFlip) {
    fc::add_bitflip(*fc_default(), identifier, bitToFlip, kHighestBit);
}

void faultcheck_addFaultBitFlipRandom(const char *identifier) {
    fc_add_bitflip_random(nullptr, identifier);
}

void faultcheck_addFaultStuckToCurrent(const char *identifier) {
    fc_add_stuck(nullptr, identifier);
}

void faultcheck_addFaultAmplification(const char *identifier, double factor) {
    fc_add_amplification(nullptr, identifier, factor);
}

void faultcheck_addFaultOffset(const char *identifier, double constant) {
    fc_add_offset(nullptr, identifier, constant);
}

void faultcheck_addFaultSetTo(const char *identifier, double value) {
    fc_add_set_to(nullptr, identifier, value);
}

void faultcheck_setTriggerOnceAfterIterations(const char *identifier, unsigned long iterations) {
    change_latest(identifier, {TriggerChange::once_after, iterations});
}

void faultcheck_setTriggerAfterIterations(const char *identifier, unsigned long iterations) {
    change_latest(identifier, {TriggerChange::after, iterations});
}

void faultcheck_setDurationAfterTrigger(const char *identifier, int iterations) {
    change_latest(identifier, {TriggerChange::duration, 0, iterations});
}

void faultcheck_removeAllFaultsIdentifier(const char *identifier) {
    fc_remove_probe_faults(nullptr, identifier);
}

void faultcheck_removeAllFaults(void) {
    fc_remove_all_probe_faults(nullptr);
}

void faultcheck_injectFaultInt(const char *identifier, int *integer) {
    fc::probe_by_name(nullptr, identifier, integer);
}

void faultcheck_injectFaultDouble(const char *identifier, double *value) {
    fc::probe_by_name(nullptr, identifier, value);
}

int faultcheck_numActiveFaults(const char *identifier) {
    return fc_num_active(nullptr, identifier);
}

void *faultcheck_instance(void) {
    return fc_default();
}

} // extern "C"
