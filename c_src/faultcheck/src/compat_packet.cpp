// faultcheck_packet_wrapper.h over the default context.
#include "faultcheck_packet_wrapper.h"

#include "api_channel.h"
#include "arming.h"

#include <limits>

namespace {

using fc::TriggerChange;

void change_latest(const char *id, const TriggerChange &change) {
    fc::change_latest_trigger(*fc_default(), fc::Space::channels, id, change);
}

void refuse(const char *id, const char *what) {
    fc::report(*fc_default(), FC_E_ARG, fc::format("channel %s: %s", fc::quoted(id).c_str(), what));
}

} // namespace

extern "C" {

void faultcheck_packet_addPacket(const char *identifier, const char *data, int len) {
    if (len < 0)
        refuse(identifier, "the length is below 0, packet not queued");
    else
        fc::channel_put(fc::context_of(nullptr), identifier, data, static_cast<std::size_t>(len));
}

// The caller vouches for the buffer, so the capacity is taken as unlimited.
int faultcheck_packet_getPacket(const char *identifier, char *data, int *len) {
    std::size_t size = 0;
    const int result = fc::channel_get(fc::context_of(nullptr), identifier, nullptr, data,
                                       std::numeric_limits<std::size_t>::max(), &size);
    if (result != 1)
        return 0;
    if (len != nullptr)
        *len = static_cast<int>(size);
    return 1;
}

void faultcheck_packet_addFaultCorruptionBitFlip(const char *identifier, int byteIndex,
                                                 int bitToFlip) {
    fc_channel_add_corruption(nullptr, identifier, byteIndex, bitToFlip);
}

void faultcheck_packet_addFaultDrop(const char *identifier, int numPackets) {
    fc_channel_add_drop(nullptr, identifier, numPackets);
}

void faultcheck_packet_addFaultRepeat(const char *identifier, int numPackets) {
    fc_channel_add_repeat(nullptr, identifier, numPackets);
}

void faultcheck_packet_setTriggerOnceAfterIterations(const char *identifier,
                                                     unsigned long iterations) {
    change_latest(identifier, {TriggerChange::once_after, iterations});
}

void faultcheck_packet_setTriggerAfterIterations(const char *identifier, unsigned long iterations) {
    change_latest(identifier, {TriggerChange::after, iterations});
}

void faultcheck_packet_setDurationAfterTrigger(const char *identifier, int iterations) {
    change_latest(identifier, {TriggerChange::duration, 0, iterations});
}

void faultcheck_packet_removeAllFaultsIdentifier(const char *identifier) {
    fc_channel_remove_faults(nullptr, identifier);
}

void faultcheck_packet_removeAllFaults(void) {
    fc_channel_remove_all_faults(nullptr);
}

} // extern "C"
