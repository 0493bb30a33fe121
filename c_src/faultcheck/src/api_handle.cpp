// What the FC_PROBE_ macros call when a probe is not idle or not known yet.
#include "probe_call.h"

namespace {

// Both fields may be written by several threads at once, each with the same values.
template <class T> int probe_by_handle(fc_handle *handle, const char *id, T *value) {
    fc_context &context = fc::context_of(nullptr);
    auto *probe = static_cast<fc::Probe *>(__atomic_load_n(&handle->probe, __ATOMIC_ACQUIRE));
    if (probe != nullptr)
        return fc::probe_record(context, *probe, value);
    const int result = fc::probe_by_name(nullptr, id, value);
    probe = context.probes.find(fc::read_name(id));
    if (probe != nullptr) { // null when memory is exhausted
        static_assert(sizeof probe->state[0] == 1);
        const auto *state =
            reinterpret_cast<const unsigned char *>(&probe->state[fc::TypeOf<T>::value]);
        __atomic_store_n(&handle->probe, static_cast<void *>(probe), __ATOMIC_RELEASE);
        __atomic_store_n(&handle->state, state, __ATOMIC_RELEASE);
    }
    return result;
}

} // namespace

extern "C" {

#define FC_HANDLE(suffix, type)                                                                    \
    int fc_handle_##suffix(fc_handle *handle, const char *id, type *value) {                       \
        return probe_by_handle(handle, id, value);                                                 \
    }

FC_HANDLE(f32, float)
FC_HANDLE(f64, double)
FC_HANDLE(i8, int8_t)
FC_HANDLE(i16, int16_t)
FC_HANDLE(i32, int32_t)
FC_HANDLE(i64, int64_t)
FC_HANDLE(u8, uint8_t)
FC_HANDLE(u16, uint16_t)
FC_HANDLE(u32, uint32_t)
FC_HANDLE(u64, uint64_t)
FC_HANDLE(bool, bool)

} // extern "C"
