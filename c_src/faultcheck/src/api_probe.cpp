// The probes of fc.h.
#include "apply.h"
#include "probe_call.h"

extern "C" {

int fc_probe_f32(fc_context *ctx, const char *id, float *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_f64(fc_context *ctx, const char *id, double *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_i8(fc_context *ctx, const char *id, int8_t *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_i16(fc_context *ctx, const char *id, int16_t *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_i32(fc_context *ctx, const char *id, int32_t *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_i64(fc_context *ctx, const char *id, int64_t *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_u8(fc_context *ctx, const char *id, uint8_t *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_u16(fc_context *ctx, const char *id, uint16_t *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_u32(fc_context *ctx, const char *id, uint32_t *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_u64(fc_context *ctx, const char *id, uint64_t *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_bool(fc_context *ctx, const char *id, bool *value) {
    return fc::probe_by_name(ctx, id, value);
}

int fc_probe_bytes(fc_context *ctx, const char *id, void *data, size_t len) {
    fc::ByteSpan bytes{static_cast<unsigned char *>(data), len};
    return fc::probe_by_name(ctx, id, data == nullptr && len > 0 ? nullptr : &bytes);
}

} // extern "C"
