#include "report.h"

#include "context.h"

#include <cstdarg>
#include <cstdio>
#include <new>

namespace fc {

namespace {

// Plain data: a thread-local with a destructor would keep the library from being unloaded.
struct LastError {
    int code;
    char text[304];
};
thread_local LastError last_error = {FC_OK, ""};

void print_line(const fc_error *error) {
    if (error->first)
        std::fprintf(stderr, "faultcheck: %s (%s)\n", error->text, fc_error_name(error->code));
}

void deliver(fc_context &context, const fc_error &error) {
    last_error.code = error.code;
    std::snprintf(last_error.text, sizeof last_error.text, "%s", error.text);
    context.error_count.fetch_add(1, std::memory_order_relaxed);
    const ErrorCallback callback = context.error_callback();
    if (callback.call != nullptr)
        callback.call(callback.user, &error);
    else
        print_line(&error);
}

} // namespace

void Reports::add(int code, fc_fault_id fault, bool first, const Text &text) noexcept {
    if (first_ == FC_OK)
        first_ = code;
    try {
        if (reports_ == nullptr)
            reports_ = std::make_unique<std::vector<Report>>();
        reports_->push_back({code, fault, first, text});
    } catch (const std::bad_alloc &) {
        ++lost_;
    }
}

void Reports::deliver(fc_context &context) const {
    if (reports_ != nullptr)
        for (const Report &entry : *reports_)
            fc::deliver(context, {entry.code, entry.fault, entry.first, entry.text.c_str()});
    if (lost_ > 0)
        report(context, FC_E_NOMEM,
               format("out of memory while reporting %u skipped faults", lost_));
}

int report(fc_context &context, int code, const Text &text) {
    deliver(context, {code, 0, 1, text.c_str()});
    return code;
}

int report_no_memory(fc_context &context) {
    return report(context, FC_E_NOMEM, format("out of memory, the call had no effect"));
}

Text quoted(const char *identifier) {
    constexpr std::size_t kMost = 60;
    Text text;
    char *out = text.chars;
    *out++ = '"';
    const char *in = identifier == nullptr ? "" : identifier;
    for (std::size_t at = 0; at < kMost && *in != '\0'; ++at, ++in) {
        const auto byte = static_cast<unsigned char>(*in);
        if (byte < 0x20 || byte == 0x7f)
            out += std::snprintf(out, 5, "\\x%02x", byte);
        else if (byte == '"' || byte == '\\')
            *out++ = '\\', *out++ = *in;
        else
            *out++ = *in;
    }
    std::snprintf(out, 5, "%s", *in == '\0' ? "\"" : "...\"");
    return text;
}

Text format(const char *pattern, ...) {
    Text text;
    va_list arguments;
    va_start(arguments, pattern);
    std::vsnprintf(text.chars, sizeof text.chars, pattern, arguments);
    va_end(arguments);
    return text;
}

} // namespace fc

extern "C" {

int fc_last_error(void) {
    return fc::last_error.code;
}

const char *fc_last_error_text(void) {
    return fc::last_error.text;
}

void fc_clear_last_error(void) {
    fc::last_error = {FC_OK, ""};
}

const char *fc_error_name(int code) {
    switch (code) {
    case FC_OK:
        return "FC_OK";
    case FC_E_ARG:
        return "FC_E_ARG";
    case FC_E_NOMEM:
        return "FC_E_NOMEM";
    case FC_E_BIT:
        return "FC_E_BIT";
    case FC_E_INDEX:
        return "FC_E_INDEX";
    case FC_E_VALUE:
        return "FC_E_VALUE";
    case FC_E_TYPE:
        return "FC_E_TYPE";
    case FC_E_NO_FAULT:
        return "FC_E_NO_FAULT";
    case FC_E_SPACE:
        return "FC_E_SPACE";
    case FC_E_RECEIVER:
        return "FC_E_RECEIVER";
    case FC_E_BLOCKED:
        return "FC_E_BLOCKED";
    case FC_E_IO:
        return "FC_E_IO";
    case FC_E_FORMAT:
        return "FC_E_FORMAT";
    default:
        return "FC_E_UNKNOWN";
    }
}

} // extern "C"
