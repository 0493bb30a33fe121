#include "probe_call.h"

#include "apply.h"

#include <new>

namespace fc {

namespace {

const char *const kTypeNames[kTypeCount] = {"f32", "f64", "i8",  "i16", "i32",  "i64",
                                            "u8",  "u16", "u32", "u64", "bool", "bytes"};

std::string why_skipped(const Probe &probe, const ProbeFault &fault, fc_type type, int code) {
    const std::string name = quoted(probe.name.text());
    const auto id = static_cast<long long>(fault.id);
    switch (code) {
    case FC_E_BIT:
        return format("probe %s, fault %lld: the probed %s has no bit %lld, fault skipped",
                      name.c_str(), id, kTypeNames[type], static_cast<long long>(fault.model.bit));
    case FC_E_VALUE:
        return format("probe %s, fault %lld: the result does not exist as %s, value left as it was",
                      name.c_str(), id, kTypeNames[type]);
    default:
        return format("probe %s, fault %lld: the model does not apply to %s, fault skipped",
                      name.c_str(), id, kTypeNames[type]);
    }
}

// Under the probe's lock.
template <class T> void walk_faults(Probe &probe, T *value, Reports &reports) {
    constexpr fc_type type = TypeOf<T>::value;
    for (ProbeFault &fault : probe.faults) {
        if (!fault.run.advance(fault.enabled))
            continue;
        const int code = apply(fault.model, fault.run.state, fault.random, value);
        fault.run.count(code);
        if (code != FC_OK)
            reports.add(code, fault.id, fault.meets(code), why_skipped(probe, fault, type, code));
    }
}

// The first call of an identifier with a type: it is listed from now on.
Probe &see(fc_context &context, Probe *known, const Name &name, fc_type type) {
    const std::lock_guard<std::mutex> hold(context.arming);
    Probe &probe = known != nullptr ? *known : context.probe(name);
    probe.listed = true;
    probe.state[type].fetch_and(static_cast<std::uint8_t>(~Probe::kUnseen),
                                std::memory_order_relaxed);
    return probe;
}

template <class T> int probe_known(fc_context &context, Probe &probe, T *value) {
    Reports reports;
    {
        const std::lock_guard<SpinLock> hold(probe.lock);
        if (!probe.faults.empty())
            ++probe.calls;
        walk_faults(probe, value, reports);
    }
    if (reports.empty())
        return FC_OK;
    reports.deliver(context);
    return reports.code();
}

} // namespace

template <class T> int probe_slowly(fc_context &context, Probe *known, const Name &name, T *value) {
    constexpr fc_type type = TypeOf<T>::value;
    return guarded(context, [&]() -> int {
        if (value == nullptr)
            return report(context, FC_E_ARG,
                          format("probe %s: value is NULL", quoted(name.bytes).c_str()).c_str());
        Probe *probe = known;
        if (probe == nullptr ||
            (probe->state[type].load(std::memory_order_relaxed) & Probe::kUnseen) != 0)
            probe = &see(context, known, name, type);
        return probe_known(context, *probe, value);
    });
}

template int probe_slowly(fc_context &, Probe *, const Name &, float *);
template int probe_slowly(fc_context &, Probe *, const Name &, double *);
template int probe_slowly(fc_context &, Probe *, const Name &, std::int8_t *);
template int probe_slowly(fc_context &, Probe *, const Name &, std::int16_t *);
template int probe_slowly(fc_context &, Probe *, const Name &, std::int32_t *);
template int probe_slowly(fc_context &, Probe *, const Name &, std::int64_t *);
template int probe_slowly(fc_context &, Probe *, const Name &, std::uint8_t *);
template int probe_slowly(fc_context &, Probe *, const Name &, std::uint16_t *);
template int probe_slowly(fc_context &, Probe *, const Name &, std::uint32_t *);
template int probe_slowly(fc_context &, Probe *, const Name &, std::uint64_t *);
template int probe_slowly(fc_context &, Probe *, const Name &, bool *);
template int probe_slowly(fc_context &, Probe *, const Name &, ByteSpan *);

} // namespace fc
