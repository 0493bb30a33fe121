// fc_record_text, fc_compare and its other form: what can be done with recordings, without a
// context of their own.
#include "compare.h"
#include "context.h"
#include "json_text.h"

#include <cstring>
#include <memory>

namespace fc {

namespace {

template <class T> T load(const char *bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

std::string json_content(fc_type type, const char *bytes, std::size_t size) {
    switch (type) {
    case FC_F32:
        return json_float(static_cast<double>(load<float>(bytes)));
    case FC_F64:
        return json_float(load<double>(bytes));
    case FC_I8:
        return std::to_string(load<std::int8_t>(bytes));
    case FC_I16:
        return std::to_string(load<std::int16_t>(bytes));
    case FC_I32:
        return std::to_string(load<std::int32_t>(bytes));
    case FC_I64:
        return std::to_string(load<std::int64_t>(bytes));
    case FC_U8:
        return std::to_string(load<std::uint8_t>(bytes));
    case FC_U16:
        return std::to_string(load<std::uint16_t>(bytes));
    case FC_U32:
        return std::to_string(load<std::uint32_t>(bytes));
    case FC_U64:
        return std::to_string(load<std::uint64_t>(bytes));
    case FC_BOOL:
        return load<std::uint8_t>(bytes) != 0 ? "true" : "false";
    case FC_BYTES:
        break;
    }
    return json_hex(bytes, size);
}

const char *kind_of(const RecordedCall &call) {
    if (call.is_packet)
        return call.flag ? "put" : "get";
    return call.flag ? "monitor" : "probe";
}

std::string line_of(const RecordedCall &call, const std::string &name) {
    std::string line = "{\"sequence\":" + std::to_string(call.sequence);
    line += ",\"time_ns\":" + std::to_string(call.time);
    line += std::string(",\"kind\":\"") + kind_of(call) + "\",\"id\":" + json_string(name);
    line += std::string(",\"type\":\"") + name_of_type(call.type) + "\"";
    line += ",\"before\":" + json_content(call.type, call.before, call.before_size);
    line += ",\"after\":" + json_content(call.type, call.after, call.after_size);
    return line + ",\"faults\":" + std::to_string(call.faults) + "}";
}

int report_format(const RecordingReader &reader, const char *which) {
    return report(context_of(nullptr), FC_E_FORMAT,
                  format("%s, byte %zu: %s", which, reader.position(), reader.error()));
}

int refuse(const char *why) {
    return report(context_of(nullptr), FC_E_ARG, format("%s", why));
}

struct Recording {
    const void *data;
    std::size_t size;
};

// FC_OK, FC_E_ARG or FC_E_FORMAT. Throws std::bad_alloc.
int compare_all(const Recording &golden, const Recording &run, const fc_tolerance *tolerance,
                std::vector<Divergence> *results) {
    if ((golden.data == nullptr && golden.size > 0) || (run.data == nullptr && run.size > 0))
        return refuse("compare: a recording is NULL");
    if (tolerance != nullptr && !(tolerance->absolute >= 0 && tolerance->relative >= 0))
        return refuse("compare: the tolerances must be numbers >= 0");
    RecordingReader first(golden.data, golden.size);
    RecordingReader second(run.data, run.size);
    *results = compare(first, second, tolerance == nullptr ? fc_tolerance{0, 0} : *tolerance);
    if (first.error() != nullptr)
        return report_format(first, "golden recording");
    if (second.error() != nullptr)
        return report_format(second, "recording of the run");
    for (Divergence &result : *results) {
        result.found.id = result.name.text.c_str();
        result.found.is_channel = result.name.is_channel;
    }
    return FC_OK;
}

} // namespace

} // namespace fc

struct fc_comparison {
    std::vector<fc::Divergence> results;
};

extern "C" {

int fc_record_text(const void *recording, size_t len, fc_line_fn line, void *user) {
    if (recording == nullptr && len > 0)
        return fc::refuse("fc_record_text: recording is NULL");
    if (line == nullptr)
        return fc::refuse("fc_record_text: line is NULL");
    return fc::guarded(fc::context_of(nullptr), [&]() -> int {
        fc::RecordingReader reader(recording, len);
        fc::RecordedCall call;
        while (reader.next(&call))
            line(user, fc::line_of(call, reader.names()[call.name].text).c_str());
        return reader.error() == nullptr ? FC_OK : fc::report_format(reader, "recording");
    });
}

int fc_compare(const void *golden, size_t golden_len, const void *run, size_t run_len,
               const fc_tolerance *tolerance, fc_divergence_fn visit, void *user) {
    if (visit == nullptr)
        return fc::refuse("fc_compare: visit is NULL");
    return fc::guarded(fc::context_of(nullptr), [&]() -> int {
        std::vector<fc::Divergence> results;
        const int code = fc::compare_all({golden, golden_len}, {run, run_len}, tolerance, &results);
        if (code != FC_OK)
            return code;
        for (const fc::Divergence &result : results)
            visit(user, &result.found);
        return static_cast<int>(results.size());
    });
}

fc_comparison *fc_comparison_new(const void *golden, size_t golden_len, const void *run,
                                 size_t run_len, const fc_tolerance *tolerance) {
    fc_comparison *made = nullptr;
    fc::guarded(fc::context_of(nullptr), [&]() -> int {
        auto comparison = std::make_unique<fc_comparison>();
        const int code =
            fc::compare_all({golden, golden_len}, {run, run_len}, tolerance, &comparison->results);
        if (code == FC_OK)
            made = comparison.release();
        return code;
    });
    return made;
}

const fc_divergence *fc_comparison_at(const fc_comparison *comparison, size_t at) {
    return at < comparison->results.size() ? &comparison->results[at].found : nullptr;
}

void fc_comparison_free(fc_comparison *comparison) {
    delete comparison;
}

} // extern "C"
