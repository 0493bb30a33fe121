// The monitors and the recordings of fc_record.h.
#include "apply.h"
#include "probe_call.h"

namespace fc {

namespace {

// The value of a monitor is never changed: it is recorded as it came, past the faults.
template <class T> int monitor(fc_context *ctx, const char *id, const T &value) {
    fc_context &context = context_of(ctx);
    return guarded(context, [&]() -> int {
        Probe &probe = monitored(context, id, TypeOf<T>::value);
        const bool recording = context.recording.load(std::memory_order_relaxed);
        const std::int64_t now = recording ? context.clock.now() : 0;
        RecordedContent content{&value, sizeof value};
        if constexpr (std::is_same_v<T, ByteSpan>)
            content = {value.data, value.size};
        const std::lock_guard<SpinLock> hold(probe.lock);
        ++probe.calls;
        if (recording)
            context.recorder.write(probe.name.text(), &probe.recorded_as,
                                   {false, TypeOf<T>::value, true, now, 0, content, content});
        return FC_OK;
    });
}

int report_recording(fc_context &context, int code, const char *file) {
    if (code == FC_OK)
        return FC_OK;
    const char *what = code == FC_E_IO ? "cannot be written" : "does not fit the memory";
    return report(
        context, code,
        format("recording %s %s", quoted(file == nullptr ? "in memory" : file).c_str(), what));
}

int stop_recording(fc_context &context) {
    const std::lock_guard<std::mutex> armed(context.arming);
    context.recording.store(false, std::memory_order_relaxed);
    context.watch();
    return context.recorder.stop();
}

int start_recording(fc_context &context, const char *file) {
    const std::lock_guard<std::mutex> armed(context.arming);
    const int code = context.recorder.start(file);
    context.recording.store(code == FC_OK, std::memory_order_relaxed);
    context.watch();
    return code;
}

} // namespace

} // namespace fc

extern "C" {

#define FC_MONITOR(suffix, type)                                                                   \
    int fc_monitor_##suffix(fc_context *ctx, const char *id, type value) {                         \
        return fc::monitor(ctx, id, value);                                                        \
    }

FC_MONITOR(f32, float)
FC_MONITOR(f64, double)
FC_MONITOR(i8, int8_t)
FC_MONITOR(i16, int16_t)
FC_MONITOR(i32, int32_t)
FC_MONITOR(i64, int64_t)
FC_MONITOR(u8, uint8_t)
FC_MONITOR(u16, uint16_t)
FC_MONITOR(u32, uint32_t)
FC_MONITOR(u64, uint64_t)
FC_MONITOR(bool, bool)

int fc_monitor_bytes(fc_context *ctx, const char *id, const void *data, size_t len) {
    if (data == nullptr && len > 0)
        return fc::report(fc::context_of(ctx), FC_E_ARG,
                          fc::format("monitor %s: data is NULL", fc::quoted(id).c_str()));
    // The bytes are only read.
    const fc::ByteSpan bytes{static_cast<unsigned char *>(const_cast<void *>(data)), len};
    return fc::monitor(ctx, id, bytes);
}

int fc_record_start(fc_context *ctx, const char *file) {
    fc_context &context = fc::context_of(ctx);
    return fc::report_recording(context, fc::start_recording(context, file), file);
}

int fc_record_stop(fc_context *ctx) {
    fc_context &context = fc::context_of(ctx);
    return fc::report_recording(context, fc::stop_recording(context), nullptr);
}

size_t fc_record_copy(fc_context *ctx, void *data, size_t capacity) {
    return fc::context_of(ctx).recorder.copy(data, capacity);
}

} // extern "C"
