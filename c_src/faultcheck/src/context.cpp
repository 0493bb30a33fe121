#include "context.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <new>

namespace fc {

std::atomic<fc_context *> default_context{nullptr};

namespace {

std::mutex default_mutex;
std::atomic<std::uint64_t> next_context{1};

// FC_SEED when it is a number, otherwise the usual seed and a line about it.
std::uint64_t seed_from_environment() {
    const char *text = std::getenv("FC_SEED");
    const fc_options defaults = FC_OPTIONS_INIT;
    if (text == nullptr || *text == '\0')
        return defaults.seed;
    char *end = nullptr;
    errno = 0;
    const unsigned long long seed = std::strtoull(text, &end, 0);
    if (errno == 0 && *end == '\0' && *text != '-')
        return seed;
    std::fprintf(stderr, "faultcheck: FC_SEED=%s is not a number 0..2^64-1, seed 1 is used\n",
                 text);
    return defaults.seed;
}

// There is no way to tell a probe that it has no context, so this ends the program.
fc_context *make_default() {
    try {
        fc_options options = FC_OPTIONS_INIT;
        options.seed = seed_from_environment();
        return new fc_context(options);
    } catch (const std::bad_alloc &) {
        std::fputs("faultcheck: out of memory for the default context\n", stderr);
        std::abort();
    }
}

} // namespace

} // namespace fc

using fc::Channel;
using fc::Probe;

fc_context::fc_context(const fc_options &options)
    : number(fc::next_context.fetch_add(1, std::memory_order_relaxed)), seed(options.seed),
      first_seed(options.seed), on_error_{options.on_error, options.error_user} {}

fc::ErrorCallback fc_context::error_callback() const {
    const std::lock_guard<fc::SpinLock> hold(callback_lock_);
    return on_error_;
}

void fc_context::set_error_callback(fc::ErrorCallback callback) {
    const std::lock_guard<fc::SpinLock> hold(callback_lock_);
    on_error_ = callback;
}

Probe &fc_context::probe(const fc::Name &name) {
    Probe *known = probes.find(name);
    return known != nullptr ? *known : probes.add(name);
}

Channel &fc_context::channel(const fc::Name &name) {
    if (Channel *known = channels.find(name))
        return *known;
    Channel &added = channels.add(name);
    added.watch(watched());
    return added;
}

void fc_context::reset() {
    for (const auto &probe : probes.all()) {
        const std::lock_guard<fc::SpinLock> hold(probe->lock);
        probe->reset();
    }
    {
        const std::lock_guard<fc::SpinLock> hold(traffic);
        for (const auto &channel : channels.all())
            channel->reset();
    }
    faults.clear();
    next_fault = 1;
    recorder.clear();
    recording.store(false, std::memory_order_relaxed);
    counting = false;
    seed = first_seed;
    clock.set_manual(0);
    error_count.store(0, std::memory_order_relaxed);
    note_change();
}

void fc_context::reseed(std::uint64_t new_seed) {
    seed = new_seed;
    for (const auto &probe : probes.all()) {
        const std::lock_guard<fc::SpinLock> hold(probe->lock);
        for (fc::ProbeFault &fault : probe->faults)
            fault.random = fc::RandomStream(seed, probe->name.text(), fault.ordinal);
    }
    const std::lock_guard<fc::SpinLock> hold(traffic);
    for (const auto &channel : channels.all())
        for (fc::ChannelFault &fault : channel->faults)
            fault.random = fc::RandomStream(seed, channel->name.text(), fault.ordinal);
}

bool fc_context::watched() const {
    return counting || recording.load(std::memory_order_relaxed);
}

void fc_context::watch() {
    for (const auto &probe : probes.all()) {
        const std::lock_guard<fc::SpinLock> hold(probe->lock);
        probe->watch(watched());
    }
    {
        const std::lock_guard<fc::SpinLock> hold(traffic);
        for (const auto &channel : channels.all())
            channel->watch(watched());
    }
    note_change();
}

extern "C" {

fc_context *fc_new(const fc_options *options) {
    const fc_options defaults = FC_OPTIONS_INIT;
    const fc_options &chosen = options != nullptr ? *options : defaults;
    if (chosen.size != sizeof(fc_options)) {
        fc::report(
            *fc_default(), FC_E_ARG,
            fc::format("fc_new: options->size is not sizeof(fc_options), use FC_OPTIONS_INIT"));
        return nullptr;
    }
    try {
        return new fc_context(chosen);
    } catch (const std::bad_alloc &) {
        fc::report(*fc_default(), FC_E_NOMEM, fc::format("fc_new: out of memory"));
        return nullptr;
    }
}

void fc_free(fc_context *ctx) {
    if (ctx != nullptr && ctx == fc::default_context.load())
        fc::report(*ctx, FC_E_ARG,
                   fc::format("fc_free: the default context cannot be freed, use fc_reset"));
    else
        delete ctx;
}

// The default context lives on the heap and is never freed: threads and static destructors may
// still be probing, and a snapshot of this library's variables that is restored later holds a
// pointer that is still good.
fc_context *fc_default(void) {
    fc_context *known = fc::default_context.load(std::memory_order_acquire);
    if (known != nullptr)
        return known;
    const std::lock_guard<std::mutex> hold(fc::default_mutex);
    known = fc::default_context.load(std::memory_order_relaxed);
    if (known == nullptr) {
        known = fc::make_default();
        fc::default_context.store(known, std::memory_order_release);
    }
    return known;
}

void fc_reset(fc_context *ctx) {
    fc_context &context = fc::context_of(ctx);
    const std::lock_guard<std::mutex> hold(context.arming);
    context.reset();
}

void fc_seed(fc_context *ctx, uint64_t seed) {
    fc_context &context = fc::context_of(ctx);
    const std::lock_guard<std::mutex> hold(context.arming);
    context.reseed(seed);
}

void fc_set_clock(fc_context *ctx, fc_clock_fn clock, void *user) {
    fc_context &context = fc::context_of(ctx);
    fc::guarded(context, [&]() -> int {
        context.clock.use(clock, user);
        return FC_OK;
    });
}

void fc_advance(fc_context *ctx, int64_t ns) {
    fc::context_of(ctx).clock.advance(ns);
}

int64_t fc_now(fc_context *ctx) {
    return fc::context_of(ctx).clock.now();
}

void fc_set_error_callback(fc_context *ctx, fc_error_fn on_error, void *user) {
    fc::context_of(ctx).set_error_callback({on_error, user});
}

uint64_t fc_error_count(fc_context *ctx) {
    return fc::context_of(ctx).error_count.load(std::memory_order_relaxed);
}

} // extern "C"
