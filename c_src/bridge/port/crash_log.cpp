#include "crash_log.hpp"

#include "../core/library.hpp"
#include "../core/sanitizer.hpp"

#include <dlfcn.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/uio.h>
#include <ucontext.h>
#include <unistd.h>
#include <unwind.h>

#include <cstdint>
#include <cstring>

namespace cb {

namespace {

// Everything below runs in a signal handler: no memory is allocated, nothing is locked but what
// dladdr needs.

constexpr std::size_t kStack = 256 * 1024;
constexpr unsigned kFirstFrames = 48;
constexpr unsigned kLastFrames = 16;

struct Signal {
    int number;
    const char *name;
};
constexpr Signal kSignals[] = {{SIGSEGV, "SIGSEGV"}, {SIGBUS, "SIGBUS"},   {SIGFPE, "SIGFPE"},
                               {SIGILL, "SIGILL"},   {SIGABRT, "SIGABRT"}, {SIGTRAP, "SIGTRAP"},
                               {SIGSYS, "SIGSYS"},   {SIGQUIT, "SIGQUIT"}};

class Line {
  public:
    Line &text(const char *text) {
        while (*text != '\0' && used_ < sizeof buffer_ - 1) {
            buffer_[used_++] = *text++;
        }
        return *this;
    }
    Line &hex(std::uint64_t value) {
        char digits[17];
        unsigned at = 16;
        digits[at] = '\0';
        do {
            digits[--at] = "0123456789abcdef"[value & 15U];
            value >>= 4;
        } while (value != 0);
        return text("0x").text(digits + at);
    }
    Line &decimal(std::int64_t value) {
        char digits[21];
        unsigned at = 20;
        digits[at] = '\0';
        const bool negative = value < 0;
        auto rest =
            negative ? 0 - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
        do {
            digits[--at] = static_cast<char>('0' + rest % 10);
            rest /= 10;
        } while (rest != 0);
        return text(negative ? "-" : "").text(digits + at);
    }
    void write() {
        buffer_[used_++] = '\n';
        std::size_t done = 0;
        while (done < used_) {
            const ssize_t count = ::write(STDERR_FILENO, buffer_ + done, used_ - done);
            if (count <= 0) {
                return;
            }
            done += static_cast<std::size_t>(count);
        }
    }

  private:
    char buffer_[1024];
    std::size_t used_ = 0;
};

struct Trace {
    std::uintptr_t faulting;
    bool found = false; // the faulting instruction: frames before it are the handler's own
    unsigned total = 0;
    std::uintptr_t first[kFirstFrames];
    std::uintptr_t last[kLastFrames];

    void add(std::uintptr_t address) {
        if (total < kFirstFrames) {
            first[total] = address;
        } else {
            last[(total - kFirstFrames) % kLastFrames] = address;
        }
        ++total;
    }
};

_Unwind_Reason_Code note_frame(_Unwind_Context *context, void *data) {
    auto *trace = static_cast<Trace *>(data);
    const std::uintptr_t address = _Unwind_GetIP(context);
    trace->found = trace->found || address == trace->faulting;
    if (trace->found && address != 0) {
        trace->add(address);
    }
    return _URC_NO_REASON;
}

bool read_memory(std::uintptr_t address, std::uintptr_t *out, std::size_t words) {
    iovec local{out, words * sizeof *out};
    iovec remote{reinterpret_cast<void *>(address), words * sizeof *out};
    return process_vm_readv(getpid(), &local, 1, &remote, 1, 0) ==
           static_cast<ssize_t>(words * sizeof *out);
}

// After a jump to an address without code: nothing tells how to unwind from there, but the return
// address is on top of the stack, and frame pointers lead on in code that keeps them.
void trace_by_frame_pointers(Trace &trace, std::uintptr_t stack, std::uintptr_t frame) {
    std::uintptr_t words[2];
    trace.add(trace.faulting);
    if (read_memory(stack, words, 1)) {
        trace.add(words[0]);
    }
    for (unsigned i = 0; i < kFirstFrames; ++i) {
        if (frame <= stack || frame % sizeof frame != 0 || !read_memory(frame, words, 2) ||
            words[1] == 0) {
            return;
        }
        trace.add(words[1]);
        stack = frame;
        frame = words[0];
    }
}

void write_frame(std::uintptr_t address, bool exact) {
    Dl_info info;
    // The byte before a return address belongs to the call, which may be the last of its function.
    const bool known =
        dladdr(reinterpret_cast<void *>(exact ? address : address - 1), &info) != 0 &&
        info.dli_fname != nullptr;
    const auto base = reinterpret_cast<std::uintptr_t>(info.dli_fbase);
    Line()
        .text("@c_bridge frame ")
        .text(known ? original_file(info.dli_fname) : "?")
        .text(" ")
        .hex(known ? address - base : address)
        .write();
}

void write_trace(const Trace &trace) {
    for (unsigned i = 0; i < trace.total && i < kFirstFrames; ++i) {
        write_frame(trace.first[i], i == 0);
    }
    if (trace.total <= kFirstFrames) {
        return;
    }
    const unsigned rest = trace.total - kFirstFrames;
    const unsigned shown = rest < kLastFrames ? rest : kLastFrames;
    if (rest > shown) {
        Line().text("@c_bridge skipped ").decimal(rest - shown).write();
    }
    for (unsigned i = rest - shown; i < rest; ++i) {
        write_frame(trace.last[i % kLastFrames], false);
    }
}

const char *signal_name(int number) {
    for (const Signal &signal : kSignals) {
        if (signal.number == number) {
            return signal.name;
        }
    }
    return "signal";
}

void handle(int number, siginfo_t *info, void *context) {
    const mcontext_t &machine = static_cast<ucontext_t *>(context)->uc_mcontext;
    Trace trace;
    trace.faulting = static_cast<std::uintptr_t>(machine.gregs[REG_RIP]);
    Line()
        .text("@c_bridge signal ")
        .decimal(number)
        .text(" ")
        .text(signal_name(number))
        .text(" code ")
        .decimal(info->si_code)
        .text(" addr ")
        .hex(info->si_code > 0 ? reinterpret_cast<std::uintptr_t>(info->si_addr) : 0)
        .text(" pc ")
        .hex(trace.faulting)
        .write();
    _Unwind_Backtrace(note_frame, &trace);
    if (trace.total <= 1) {
        trace.total = 0;
        trace_by_frame_pointers(trace, static_cast<std::uintptr_t>(machine.gregs[REG_RSP]),
                                static_cast<std::uintptr_t>(machine.gregs[REG_RBP]));
    }
    write_trace(trace);
    raise(number); // now with its default effect, as soon as this handler returns
}

} // namespace

void install_crash_handlers() {
    void *stack = mmap(nullptr, kStack, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (stack != MAP_FAILED && !under_address_sanitizer()) {
        stack_t alternate{};
        alternate.ss_sp = stack;
        alternate.ss_size = kStack;
        sigaltstack(&alternate, nullptr);
    }
    Trace trace{};
    _Unwind_Backtrace(note_frame, &trace); // loads and prepares what unwinding needs
    for (const Signal &signal : kSignals) {
        if (under_address_sanitizer() && signal.number != SIGQUIT) {
            continue;
        }
        struct sigaction action {};
        action.sa_sigaction = handle;
        action.sa_flags = SA_SIGINFO | SA_ONSTACK | static_cast<int>(SA_RESETHAND);
        sigaction(signal.number, &action, nullptr);
    }
}

} // namespace cb
