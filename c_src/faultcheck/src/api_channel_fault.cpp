// The faults on channels of fc_channel.h.
#include "arming.h"

#include <cstring>
#include <new>
#include <stdexcept>

namespace {

using fc::ChannelModel;
using fc::ChannelModelKind;

// Why a fault is refused; FC_OK: it is not.
struct Refusal {
    int code = FC_OK;
    const char *why = "";
};

Refusal unless(bool good, int code, const char *why) {
    return good ? Refusal() : Refusal{code, why};
}

// Fills a model, which may need memory, and arms it.
template <class Fill>
fc_fault_id add(fc_context *ctx, const char *channel, ChannelModelKind kind, const Refusal &refusal,
                Fill fill) {
    fc_context &context = fc::context_of(ctx);
    ChannelModel model;
    model.kind = kind;
    Refusal refused = refusal;
    if (refused.code == FC_OK) {
        try {
            fill(model);
        } catch (const std::bad_alloc &) {
            refused = {FC_E_NOMEM, "out of memory"};
        } catch (const std::length_error &) { // more than any memory could hold
            refused = {FC_E_NOMEM, "out of memory"};
        }
    }
    return fc::add_channel_fault(context, channel, model, refused.code, refused.why);
}

fc_fault_id add_number(fc_context *ctx, const char *channel, ChannelModelKind kind,
                       std::int64_t number, const char *why) {
    return add(ctx, channel, kind, unless(number >= 0, FC_E_ARG, why), [&](ChannelModel &model) {
        model.index = number;
        model.budget = static_cast<std::uint64_t>(number);
    });
}

fc_fault_id add_plain(fc_context *ctx, const char *channel, ChannelModelKind kind) {
    return add(ctx, channel, kind, Refusal(), [](ChannelModel &) {});
}

fc_fault_id add_name(fc_context *ctx, const char *channel, ChannelModelKind kind,
                     const char *name) {
    return add(ctx, channel, kind, Refusal(),
               [&](ChannelModel &model) { model.text = name == nullptr ? "" : name; });
}

// A caller in C may have put any number there, which must not be read as the enumeration then.
bool has_type(const fc_field &field) {
    static_assert(sizeof field.type == sizeof(int), "an enumeration is an int");
    int type;
    std::memcpy(&type, &field.type, sizeof type);
    return type >= FC_F32 && type <= FC_BYTES;
}

Refusal check_field(const fc_field *field, const fc_model *model) {
    if (model == nullptr)
        return {FC_E_ARG, "the model is NULL"};
    if (field != nullptr && !has_type(*field))
        return {FC_E_ARG, "the field has no such type"};
    Refusal refusal;
    refusal.code = fc::check_model(*model, &refusal.why);
    return refusal;
}

void copy_receivers(ChannelModel &model, const char *const *receivers, size_t count) {
    for (size_t at = 0; at < count; ++at)
        model.receivers.emplace_back(receivers[at] == nullptr ? "" : receivers[at]);
}

} // namespace

extern "C" {

fc_fault_id fc_channel_add_corruption(fc_context *ctx, const char *channel, int byte, int bit) {
    const Refusal bad_bit = unless(bit >= 0 && bit <= 7, FC_E_BIT, "the bit is not one of 0..7");
    const Refusal refusal = byte < 0 ? Refusal{FC_E_INDEX, "the byte index is below 0"} : bad_bit;
    return add(ctx, channel, ChannelModelKind::corruption, refusal, [&](ChannelModel &model) {
        model.index = byte;
        model.bit = bit;
    });
}

fc_fault_id fc_channel_add_field(fc_context *ctx, const char *channel, const fc_field *field,
                                 const fc_model *model) {
    const Refusal refusal =
        field == nullptr ? Refusal{FC_E_ARG, "the field is NULL"} : check_field(field, model);
    return add(ctx, channel, ChannelModelKind::field, refusal, [&](ChannelModel &added) {
        added.field = *field;
        added.model = *model;
    });
}

fc_fault_id fc_channel_add_truncate(fc_context *ctx, const char *channel, size_t bytes) {
    return add_number(ctx, channel, ChannelModelKind::truncate, static_cast<std::int64_t>(bytes),
                      "the length is above 2^63");
}

fc_fault_id fc_channel_add_extend(fc_context *ctx, const char *channel, size_t count,
                                  unsigned char byte) {
    const auto number = static_cast<std::int64_t>(count);
    return add(ctx, channel, ChannelModelKind::extend,
               unless(number >= 0, FC_E_ARG, "the length is above 2^63"), [&](ChannelModel &model) {
                   model.index = number;
                   model.bit = byte;
               });
}

fc_fault_id fc_channel_add_drop(fc_context *ctx, const char *channel, int64_t packets) {
    return add_number(ctx, channel, ChannelModelKind::drop, packets,
                      "the number of packets is below 0");
}

fc_fault_id fc_channel_add_repeat(fc_context *ctx, const char *channel, int64_t packets) {
    return add_number(ctx, channel, ChannelModelKind::repeat, packets,
                      "the number of packets is below 0");
}

fc_fault_id fc_channel_add_lose(fc_context *ctx, const char *channel) {
    return add_plain(ctx, channel, ChannelModelKind::lose);
}

fc_fault_id fc_channel_add_repeat_last(fc_context *ctx, const char *channel) {
    return add_plain(ctx, channel, ChannelModelKind::repeat_last);
}

fc_fault_id fc_channel_add_insert(fc_context *ctx, const char *channel, const void *data,
                                  size_t len, int64_t times) {
    const Refusal bad_times = unless(times >= 0, FC_E_ARG, "the number of packets is below 0");
    const Refusal refusal =
        data == nullptr && len > 0 ? Refusal{FC_E_ARG, "data is NULL"} : bad_times;
    return add(ctx, channel, ChannelModelKind::insert, refusal, [&](ChannelModel &model) {
        if (len > 0)
            model.text.assign(static_cast<const char *>(data), len);
        model.budget = static_cast<std::uint64_t>(times);
    });
}

fc_fault_id fc_channel_add_masquerade(fc_context *ctx, const char *channel, const char *from) {
    return add_name(ctx, channel, ChannelModelKind::masquerade, from);
}

fc_fault_id fc_channel_add_resequence(fc_context *ctx, const char *channel, int64_t position) {
    return add_number(ctx, channel, ChannelModelKind::resequence, position,
                      "the position is below 0");
}

fc_fault_id fc_channel_add_block_get(fc_context *ctx, const char *channel) {
    return add_plain(ctx, channel, ChannelModelKind::block_get);
}

int fc_channel_fault_receiver(fc_context *ctx, fc_fault_id fault, const char *receiver) {
    fc_context &context = fc::context_of(ctx);
    return fc::guarded(context, [&] { return fc::restrict_fault(context, fault, receiver); });
}

fc_fault_id fc_channel_add_delay(fc_context *ctx, const char *channel, int64_t gets) {
    return add_number(ctx, channel, ChannelModelKind::delay_gets, gets,
                      "the number of gets is below 0");
}

fc_fault_id fc_channel_add_delay_time(fc_context *ctx, const char *channel, int64_t ns) {
    return add_number(ctx, channel, ChannelModelKind::delay_time, ns, "the time is below 0");
}

fc_fault_id fc_channel_add_misroute(fc_context *ctx, const char *channel, const char *to) {
    return add_name(ctx, channel, ChannelModelKind::misroute, to);
}

fc_fault_id fc_channel_add_asymmetric(fc_context *ctx, const char *channel,
                                      const char *const *receivers, size_t count,
                                      const fc_field *field, const fc_model *model) {
    const Refusal refusal =
        receivers == nullptr ? Refusal{FC_E_ARG, "receivers is NULL"} : check_field(field, model);
    return add(ctx, channel, ChannelModelKind::asymmetric, refusal, [&](ChannelModel &added) {
        copy_receivers(added, receivers, count);
        if (field != nullptr)
            added.field = *field;
        added.model = *model;
    });
}

fc_fault_id fc_channel_add_subset(fc_context *ctx, const char *channel,
                                  const char *const *receivers, size_t count) {
    return add(ctx, channel, ChannelModelKind::subset,
               unless(receivers != nullptr, FC_E_ARG, "receivers is NULL"),
               [&](ChannelModel &added) { copy_receivers(added, receivers, count); });
}

fc_fault_id fc_channel_add_block_put(fc_context *ctx, const char *channel) {
    return add_plain(ctx, channel, ChannelModelKind::block_put);
}

} // extern "C"
