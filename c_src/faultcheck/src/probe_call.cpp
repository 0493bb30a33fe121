#include "probe_call.h"

#include "apply.h"
#include "call_inputs.h"

namespace fc {

namespace {

Text why_skipped(const Probe &probe, const ProbeFault &fault, fc_type type, int code) {
    const Text name = quoted(probe.name.text().c_str());
    const auto id = static_cast<long long>(fault.id);
    switch (code) {
    case FC_E_BIT:
        return format("probe %s, fault %lld: the probed %s has no bit %lld, fault skipped",
                      name.c_str(), id, name_of_type(type), static_cast<long long>(fault.model.n));
    case FC_E_VALUE:
        return format("probe %s, fault %lld: the result does not exist as %s, value left as it was",
                      name.c_str(), id, name_of_type(type));
    default:
        return format("probe %s, fault %lld: the model does not apply to %s, fault skipped",
                      name.c_str(), id, name_of_type(type));
    }
}

// Out of the way of the calls that go well.
__attribute__((noinline, cold)) void note_skipped(const Probe &probe, ProbeFault &fault,
                                                  fc_type type, int code, Reports &reports) {
    fault.run.count_skipped(code);
    reports.add(code, fault.id, fault.meets(code), why_skipped(probe, fault, type, code));
}

std::size_t size_of(const ByteSpan &bytes) {
    return bytes.size;
}
template <class T> constexpr std::size_t size_of(const T &) {
    return sizeof(T);
}

// Everything of a walk that may fail.
template <class T> __attribute__((noinline)) void prepare_faults(Probe &probe, const T &value) {
    for (ProbeFault &fault : probe.faults)
        prepare(fault.model, fault.run.state, TypeOf<T>::value, size_of(value));
}

// Under the probe's lock. Returns how many faults were applied.
template <class T>
__attribute__((always_inline)) inline std::uint32_t
walk_faults(Probe &probe, const CallInputs &inputs, T *value, Reports &reports) {
    std::uint32_t applied = 0;
    ++probe.calls;
    for (ProbeFault &fault : probe.faults) {
        if (!fault.run.advance(fault.enabled, inputs, fault.random))
            continue;
        const int code =
            apply(FaultCall{fault.model, fault.run.state, fault.random, inputs}, value);
        if (code == FC_OK)
            ++applied;
        else
            note_skipped(probe, fault, TypeOf<T>::value, code, reports);
    }
    return applied;
}

RecordedContent content_of(const ByteSpan &bytes) {
    return {bytes.data, bytes.size};
}
template <class T> RecordedContent content_of(const T &value) {
    return {&value, sizeof value};
}

// A copy of the value as it was before the faults.
template <class T> class Before {
  public:
    explicit Before(const T &value) : value_(value) {}
    RecordedContent content() const {
        return content_of(value_);
    }

  private:
    T value_;
};
template <> class Before<ByteSpan> {
  public:
    explicit Before(const ByteSpan &bytes) : bytes_(bytes.data, bytes.data + bytes.size) {}
    RecordedContent content() const {
        return {bytes_.data(), bytes_.size()};
    }

  private:
    std::vector<unsigned char> bytes_;
};

// Under the probe's lock.
template <class T>
void walk_and_record(fc_context &context, Probe &probe, const CallInputs &inputs, T *value,
                     Reports &reports) {
    const Before<T> before(*value);
    const std::uint32_t applied = walk_faults(probe, inputs, value, reports);
    context.recorder.write(probe.name.text(), &probe.recorded_as,
                           {false, TypeOf<T>::value, false, inputs.now, applied, before.content(),
                            content_of(*value)});
}

int deliver(fc_context &context, const Reports &reports) {
    reports.deliver(context);
    return reports.code();
}

int report_null(fc_context &context, const char *id) {
    return report(context, FC_E_ARG, format("probe %s: value is NULL", quoted(id).c_str()));
}

// Under the probe's lock.
template <class T>
void walk_watched(fc_context &context, Probe &probe, bool recording, const CallInputs &inputs,
                  T *value, Reports &reports) {
    if (probe.has_memory)
        prepare_faults(probe, *value);
    if (recording)
        walk_and_record(context, probe, inputs, value, reports);
    else
        walk_faults(probe, inputs, value, reports);
}

// The faults may change between the asking and the call, so this asks until nothing new is wanted.
template <class T>
__attribute__((noinline)) void probe_asking(fc_context &context, Probe &probe, bool recording,
                                            T *value, Reports &reports) {
    InputGatherer gatherer;
    if (recording)
        gatherer.want_time();
    for (;;) {
        gatherer.gather(context.clock);
        const std::lock_guard<SpinLock> hold(probe.lock);
        for (const ProbeFault &fault : probe.faults)
            gatherer.want(fault.run.trigger, fault.model);
        if (gatherer.complete()) {
            walk_watched(context, probe, recording, gatherer.inputs(), value, reports);
            return;
        }
    }
}

// A call that is recorded or counted, or whose faults ask for the time or a predicate or keep
// values.
template <class T>
__attribute__((noinline)) void probe_with_inputs(fc_context &context, Probe &probe, T *value,
                                                 Reports &reports) {
    CallInputs inputs;
    inputs.has_time = context.recording.load(std::memory_order_relaxed);
    if (inputs.has_time)
        inputs.now = context.clock.now();
    {
        const std::lock_guard<SpinLock> hold(probe.lock);
        if (!probe.wants_inputs) {
            walk_watched(context, probe, inputs.has_time, inputs, value, reports);
            return;
        }
    }
    probe_asking(context, probe, inputs.has_time, value, reports);
}

constexpr CallInputs kNoInputs;

// True when the call is done.
template <class T> bool probe_without_inputs(Probe &probe, T *value, Reports &reports) {
    const std::lock_guard<SpinLock> hold(probe.lock);
    if (!probe.is_plain || probe.watched)
        return false;
    if (!probe.faults.empty())
        walk_faults(probe, kNoInputs, value, reports);
    return true;
}

// The record of an identifier that is not known, or not as this type.
Probe &meet(fc_context &context, Probe *known, const char *id) {
    const std::lock_guard<std::mutex> hold(context.arming);
    Probe &probe = known != nullptr ? *known : context.probe(read_name(id));
    if (context.watched()) {
        const std::lock_guard<SpinLock> hold_probe(probe.lock);
        probe.watch(true);
    }
    return probe;
}

// The identifier is listed from now on.
void note_seen(fc_context &context, Probe &probe, fc_type type) {
    const std::lock_guard<std::mutex> hold(context.arming);
    probe.listed = true;
    probe.state[type].fetch_and(static_cast<std::uint8_t>(~Probe::kUnseen),
                                std::memory_order_relaxed);
}

} // namespace

Probe &monitored(fc_context &context, const char *id, fc_type type) {
    Probe *known = context.probes.find(read_name(id));
    if (known == nullptr ||
        (known->state[type].load(std::memory_order_relaxed) & Probe::kUnseen) != 0) {
        Probe &probe = meet(context, known, id);
        note_seen(context, probe, type);
        return probe;
    }
    return *known;
}

template <class T> int probe_armed(fc_context &context, Probe &probe, T *value) {
    if (value == nullptr)
        return report_null(context, probe.name.text().c_str());
    // As guarded(), whose call would be felt here.
    try {
        Reports reports;
        const std::uint8_t state = probe.state[TypeOf<T>::value].load(std::memory_order_relaxed);
        if ((state & Probe::kWatched) != 0 || !probe_without_inputs(probe, value, reports))
            probe_with_inputs(context, probe, value, reports);
        return reports.empty() ? FC_OK : deliver(context, reports);
    } catch (const std::bad_alloc &) {
        return report_no_memory(context);
    } catch (const std::length_error &) {
        return report_no_memory(context);
    }
}

template <class T> int probe_unseen(fc_context &context, Probe *known, const char *id, T *value) {
    if (value == nullptr)
        return report_null(context, id);
    return guarded(context, [&]() -> int {
        Probe &probe = meet(context, known, id);
        const int result = probe_armed(context, probe, value);
        if (result != FC_E_NOMEM) // then the call has no effect
            note_seen(context, probe, TypeOf<T>::value);
        return result;
    });
}

#define FC_PROBE_TYPE(T)                                                                           \
    template int probe_armed(fc_context &, Probe &, T *);                                          \
    template int probe_unseen(fc_context &, Probe *, const char *, T *)

FC_PROBE_TYPE(float);
FC_PROBE_TYPE(double);
FC_PROBE_TYPE(std::int8_t);
FC_PROBE_TYPE(std::int16_t);
FC_PROBE_TYPE(std::int32_t);
FC_PROBE_TYPE(std::int64_t);
FC_PROBE_TYPE(std::uint8_t);
FC_PROBE_TYPE(std::uint16_t);
FC_PROBE_TYPE(std::uint32_t);
FC_PROBE_TYPE(std::uint64_t);
FC_PROBE_TYPE(bool);
FC_PROBE_TYPE(ByteSpan);

} // namespace fc
