// The listing of fc_list.h.
#include "json_text.h"
#include "listing.h"

namespace {

const char *name_of_state(fc_trigger_state state) {
    constexpr const char *names[] = {"waiting", "active", "exhausted", "disabled"};
    return names[state];
}

std::string json_of(const fc_listed_fault &fault, bool is_channel) {
    std::string text = "{\"id\":" + std::to_string(fault.id);
    text += std::string(",\"model\":\"") + fault.model + "\"";
    text += ",\"a\":" + fc::json_float(fault.a) + ",\"b\":" + fc::json_float(fault.b);
    text += ",\"n\":" + std::to_string(fault.n);
    if (is_channel)
        text += ",\"receiver\":" + fc::json_string(fault.receiver);
    text += std::string(",\"state\":\"") + name_of_state(fault.state) + "\"";
    text += ",\"calls_left\":" + std::to_string(fault.calls_left);
    text += ",\"triggered\":" + std::to_string(fault.triggered);
    text += ",\"applied\":" + std::to_string(fault.applied);
    text += ",\"skipped\":" + std::to_string(fault.skipped);
    return text + ",\"last_error\":\"" + fc_error_name(fault.last_error) + "\"}";
}

std::string json_types(std::uint32_t types) {
    std::string text = "[";
    for (int type = 0; type < fc::kTypeCount; ++type)
        if ((types >> type & 1) != 0) {
            text += text.size() > 1 ? ",\"" : "\"";
            text += std::string(fc::name_of_type(static_cast<fc_type>(type))) + "\"";
        }
    return text + "]";
}

std::string json_of(const fc_listed &listed) {
    std::string text = "{\"id\":" + fc::json_string(listed.id);
    if (listed.is_channel)
        text += ",\"kind\":\"channel\",\"gets\":" + std::to_string(listed.calls) +
                ",\"puts\":" + std::to_string(listed.puts);
    else
        text += ",\"kind\":\"probe\",\"types\":" + json_types(listed.types) +
                ",\"calls\":" + std::to_string(listed.calls);
    text += ",\"faults\":[";
    for (std::size_t at = 0; at < listed.fault_count; ++at)
        text += (at > 0 ? "," : "") + json_of(listed.faults[at], listed.is_channel);
    return text + "]}";
}

} // namespace

struct fc_listing {
    const fc::Listing content;
};

extern "C" {

int fc_list(fc_context *ctx, fc_list_fn visit, void *user) {
    fc_context &context = fc::context_of(ctx);
    if (visit == nullptr)
        return fc::report(context, FC_E_ARG, fc::format("fc_list: visit is NULL"));
    return fc::guarded(context, [&]() -> int {
        const fc::Listing listing(context);
        for (const fc::Listed &listed : listing.all())
            visit(user, &listed.entry);
        return FC_OK;
    });
}

fc_listing *fc_listing_new(fc_context *ctx) {
    fc_context &context = fc::context_of(ctx);
    fc_listing *made = nullptr;
    fc::guarded(context, [&]() -> int {
        made = new fc_listing{fc::Listing(context)};
        return FC_OK;
    });
    return made;
}

const fc_listed *fc_listing_at(const fc_listing *listing, size_t at) {
    const auto &all = listing->content.all();
    return at < all.size() ? &all[at].entry : nullptr;
}

void fc_listing_free(fc_listing *listing) {
    delete listing;
}

int fc_dump_json(fc_context *ctx, fc_line_fn line, void *user) {
    fc_context &context = fc::context_of(ctx);
    if (line == nullptr)
        return fc::report(context, FC_E_ARG, fc::format("fc_dump_json: line is NULL"));
    return fc::guarded(context, [&]() -> int {
        const fc::Listing listing(context);
        for (const fc::Listed &listed : listing.all())
            line(user, json_of(listed.entry).c_str());
        return FC_OK;
    });
}

void fc_count_calls(fc_context *ctx, bool on) {
    fc_context &context = fc::context_of(ctx);
    const std::lock_guard<std::mutex> armed(context.arming);
    context.counting = on;
    context.watch();
}

uint64_t fc_change_count(fc_context *ctx) {
    return fc::context_of(ctx).change_count.load(std::memory_order_acquire);
}

bool fc_is_watching(fc_context *ctx) {
    fc_context &context = fc::context_of(ctx);
    const std::lock_guard<std::mutex> armed(context.arming);
    return context.watched();
}

} // extern "C"
