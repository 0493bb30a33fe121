#include "compare.h"

#include "value.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <tuple>

namespace fc {

namespace {

using Key = std::pair<bool, std::string>; // is_channel, name
using Calls = std::vector<RecordedCall>;

std::map<Key, Calls> calls_by_name(RecordingReader &reader) {
    std::map<Key, Calls> calls;
    RecordedCall call;
    while (reader.next(&call)) {
        const RecordedName &name = reader.names()[call.name];
        calls[{name.is_channel, name.text}].push_back(call);
    }
    return calls;
}

template <class T> long double as_number(const char *bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<long double>(value);
}

// A long double holds every 64-bit integer.
long double number_of(const RecordedCall &call) {
    switch (call.type) {
    case FC_F32:
        return as_number<float>(call.after);
    case FC_F64:
        return as_number<double>(call.after);
    case FC_I8:
        return as_number<std::int8_t>(call.after);
    case FC_I16:
        return as_number<std::int16_t>(call.after);
    case FC_I32:
        return as_number<std::int32_t>(call.after);
    case FC_I64:
        return as_number<std::int64_t>(call.after);
    case FC_U16:
        return as_number<std::uint16_t>(call.after);
    case FC_U32:
        return as_number<std::uint32_t>(call.after);
    case FC_U64:
        return as_number<std::uint64_t>(call.after);
    default:
        return as_number<std::uint8_t>(call.after);
    }
}

bool same_bytes(const RecordedCall &a, const RecordedCall &b) {
    return a.after_size == b.after_size && std::memcmp(a.after, b.after, a.after_size) == 0;
}

// True when the call differs; the size of a difference of numbers is noted.
bool differs(const RecordedCall &golden, const RecordedCall &run, const fc_tolerance &tolerance,
             fc_divergence *found) {
    if (golden.type != run.type || golden.is_packet != run.is_packet)
        return true;
    if (golden.type == FC_BYTES)
        return !same_bytes(golden, run) || (golden.is_packet && golden.flag != run.flag);
    const long double a = number_of(golden);
    const long double b = number_of(run);
    if (a == b || (std::isnan(a) && std::isnan(b)))
        return false;
    const long double difference = std::fabs(a - b);
    if (difference <= tolerance.absolute + tolerance.relative * std::fabs(a))
        return false;
    const auto relative = static_cast<double>(difference / std::fabs(a));
    found->largest_absolute = std::fmax(found->largest_absolute, static_cast<double>(difference));
    found->largest_relative = std::fmax(found->largest_relative, relative);
    return true;
}

void note_first(Divergence *divergence, std::uint64_t call, std::int64_t time,
                std::uint64_t order) {
    divergence->found.first = call;
    divergence->found.first_ns = time;
    divergence->order = order;
}

Divergence compare_calls(const Key &key, const Calls &golden, const Calls &run,
                         const fc_tolerance &tolerance) {
    Divergence result{{key.first, key.second}, {}, 0};
    fc_divergence &found = result.found;
    found.calls = std::min(golden.size(), run.size());
    for (std::uint64_t at = 0; at < found.calls; ++at)
        if (differs(golden[at], run[at], tolerance, &found) && found.differing++ == 0)
            note_first(&result, at, run[at].time, run[at].sequence);
    found.missing = golden.size() - found.calls;
    found.extra = run.size() - found.calls;
    if (found.differing > 0)
        return result;
    if (found.extra > 0)
        note_first(&result, found.calls, run[found.calls].time, run[found.calls].sequence);
    if (found.missing > 0)
        note_first(&result, found.calls, golden[found.calls].time, UINT64_MAX);
    return result;
}

bool is_divergence(const Divergence &result) {
    return result.found.differing + result.found.missing + result.found.extra > 0;
}

} // namespace

std::vector<Divergence> compare(RecordingReader &golden, RecordingReader &run,
                                const fc_tolerance &tolerance) {
    std::map<Key, Calls> expected = calls_by_name(golden);
    std::map<Key, Calls> seen = calls_by_name(run);
    for (const auto &entry : seen)
        expected[entry.first]; // only in the run: no golden calls
    std::vector<Divergence> results;
    for (const auto &[key, calls] : expected) {
        Divergence result = compare_calls(key, calls, seen[key], tolerance);
        if (is_divergence(result))
            results.push_back(std::move(result));
    }
    std::sort(results.begin(), results.end(), [](const Divergence &a, const Divergence &b) {
        return std::tie(a.order, a.name.is_channel, a.name.text) <
               std::tie(b.order, b.name.is_channel, b.name.text);
    });
    return results;
}

} // namespace fc
