// What the FC_PROBE_ macros and resolved handles call when a probe is not idle or not known yet.
#include "apply.h"
#include "probe_call.h"

namespace {

const unsigned char *state_of(const fc::Probe &probe, int type) {
    static_assert(sizeof probe.state[0] == 1);
    return reinterpret_cast<const unsigned char *>(&probe.state[type]);
}

// Both fields may be written by several threads at once, each with the same values.
template <class T> int probe_by_handle(fc_handle *handle, const char *id, T *value) {
    fc_context &context = fc::context_of(handle->context);
    auto *probe = static_cast<fc::Probe *>(__atomic_load_n(&handle->probe, __ATOMIC_ACQUIRE));
    if (probe != nullptr)
        return fc::probe_record(context, *probe, value);
    const int result = fc::probe_by_name(handle->context, id, value);
    probe = context.probes.find(fc::read_name(id));
    if (probe != nullptr) { // null when memory is exhausted
        __atomic_store_n(&handle->probe, static_cast<void *>(probe), __ATOMIC_RELEASE);
        __atomic_store_n(&handle->state, state_of(*probe, fc::TypeOf<T>::value), __ATOMIC_RELEASE);
    }
    return result;
}

int refuse(fc_context &context, const char *id, const char *why) {
    return fc::report(context, FC_E_ARG,
                      fc::format("probe %s: %s, handle not resolved", fc::quoted(id).c_str(), why));
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

int fc_handle_bytes(fc_handle *handle, const char *id, void *data, size_t len) {
    fc::ByteSpan bytes{static_cast<unsigned char *>(data), len};
    return probe_by_handle(handle, id, data == nullptr && len > 0 ? nullptr : &bytes);
}

int fc_resolve(fc_context *ctx, const char *id, int type, fc_handle *handle) {
    fc_context &context = fc::context_of(ctx);
    if (handle == nullptr)
        return refuse(context, id, "the handle is NULL");
    if (type < FC_F32 || type > FC_BYTES)
        return refuse(context, id, "there is no such type");
    return fc::guarded(context, [&]() -> int {
        const std::lock_guard<std::mutex> hold(context.arming);
        fc::Probe &probe = context.probe(fc::read_name(id));
        *handle = {state_of(probe, type), &probe, &context};
        return FC_OK;
    });
}

} // extern "C"
