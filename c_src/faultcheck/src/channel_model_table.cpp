#include "channel_model_table.h"

#include "arming.h"
#include "recording.h"

#include <climits>
#include <cstring>
#include <limits>
#include <string>

namespace fc {

namespace {

// A fault to be armed; the arguments have been sorted to the parameters of its model.
struct Wanted {
    fc_context *ctx;
    const char *channel;
    const NamedModel &model;
    const NamedArguments &given;
    const NamedArguments &unsorted; // for a model applied

    fc_fault_id refuse(const Text &why) const {
        return add_channel_fault(context_of(ctx), channel, {}, FC_E_ARG, why.c_str());
    }
};

constexpr std::int64_t kAll = std::numeric_limits<std::int64_t>::max();

int hex_digit(char c) {
    const char *digits = "0123456789abcdef0123456789ABCDEF";
    const char *at = c == '\0' ? nullptr : std::strchr(digits, c);
    return at == nullptr ? -1 : static_cast<int>((at - digits) % 16);
}

// False when it is no hexadecimal text.
bool read_hex(const char *text, std::string *bytes) {
    for (; *text != '\0'; text += 2) {
        const int high = hex_digit(text[0]);
        const int low = high < 0 ? -1 : hex_digit(text[1]);
        if (low < 0)
            return false;
        bytes->push_back(static_cast<char>(16 * high + low));
    }
    return true;
}

fc_fault_id arm_insert(const Wanted &wanted) {
    std::string packet;
    if (!read_hex(wanted.given.text(0), &packet))
        return wanted.refuse(format("data must be an even number of hexadecimal digits"));
    return fc_channel_add_insert(wanted.ctx, wanted.channel, packet.data(), packet.size(),
                                 wanted.given.whole(1, 1));
}

fc_fault_id arm_delay(const Wanted &wanted) {
    if (wanted.given.has(0) == wanted.given.has(1))
        return wanted.refuse(format("model delay needs either gets or ns"));
    return wanted.given.has(0)
               ? fc_channel_add_delay(wanted.ctx, wanted.channel, wanted.given.whole(0, 0))
               : fc_channel_add_delay_time(wanted.ctx, wanted.channel, wanted.given.whole(1, 0));
}

// Names between commas.
struct Receivers {
    std::vector<std::string> names;
    std::vector<const char *> pointers;

    explicit Receivers(const char *text) {
        for (const char *end = text; end != nullptr; text = end + 1) {
            end = std::strchr(text, ',');
            names.emplace_back(text, end == nullptr ? std::strlen(text)
                                                    : static_cast<std::size_t>(end - text));
            if (end == nullptr)
                break;
        }
        for (const std::string &name : names)
            pointers.push_back(name.c_str());
    }
};

fc_fault_id arm_subset(const Wanted &wanted) {
    const Receivers receivers(wanted.given.text(0));
    return fc_channel_add_subset(wanted.ctx, wanted.channel, receivers.pointers.data(),
                                 receivers.pointers.size());
}

// A field from the parameters type, byte, big_endian, length; the first of them at that place.
int read_field(const Wanted &wanted, int place, fc_field *field, Text *why) {
    const char *type = wanted.given.text(place);
    *field = {static_cast<std::size_t>(wanted.given.whole(place + 1, 0)), FC_BYTES,
              wanted.given.whole(place + 2, 0) != 0,
              static_cast<std::size_t>(wanted.given.whole(place + 3, 0))};
    if (type == nullptr)
        return FC_OK;
    for (int known = FC_F32; known <= FC_BYTES; ++known)
        if (std::strcmp(type, name_of_type(static_cast<fc_type>(known))) == 0) {
            field->type = static_cast<fc_type>(known);
            return FC_OK;
        }
    *why = format("type %s is none of f32, f64, i8 to i64, u8 to u64, bool and bytes",
                  quoted(type).c_str());
    return FC_E_ARG;
}

fc_fault_id arm_field(const Wanted &wanted) {
    fc_field field;
    fc_model model;
    Text why;
    if (read_value_model(wanted.given.text(0), wanted.unsorted, &wanted.model, &model, &why) !=
            FC_OK ||
        read_field(wanted, 1, &field, &why) != FC_OK)
        return wanted.refuse(why);
    return fc_channel_add_field(wanted.ctx, wanted.channel, &field, &model);
}

fc_fault_id arm_asymmetric(const Wanted &wanted) {
    const Receivers receivers(wanted.given.text(1));
    fc_field field;
    fc_model model;
    Text why;
    if (read_value_model(wanted.given.text(0), wanted.unsorted, &wanted.model, &model, &why) !=
            FC_OK ||
        read_field(wanted, 2, &field, &why) != FC_OK)
        return wanted.refuse(why);
    return fc_channel_add_asymmetric(wanted.ctx, wanted.channel, receivers.pointers.data(),
                                     receivers.pointers.size(), &field, &model);
}

constexpr NamedParameter kApply = text("apply", nullptr, "the model of a probe that is applied");
constexpr NamedParameter kType = optional(text("type", nullptr, "of the field; bytes"));
constexpr NamedParameter kFieldByte =
    optional(whole("byte", nullptr, "where the field begins; 0", 0));
constexpr NamedParameter kBigEndian =
    optional(whole("big_endian", nullptr, "1 if the field is; 0", 0, 1));
constexpr NamedParameter kLength =
    optional(whole("length", nullptr, "of a field of bytes; all there are", 0));
constexpr NamedParameter kReceivers = text("receivers", nullptr, "their names, between commas");

struct ChannelEntry {
    NamedModel named;
    fc_fault_id (*arm)(const Wanted &wanted);
};

constexpr NamedParameter an_int(const char *name, const char *other, const char *meaning) {
    return whole(name, other, meaning, INT_MIN, INT_MAX);
}

// In the order of ChannelModelKind; then a name for two of them.
constexpr ChannelEntry kModels[] = {
    {{"corruption",
      "bitflip",
      {an_int("byte", nullptr, "from 0"), an_int("bit", nullptr, "0..7, 0 the least significant")},
      false},
     [](const Wanted &w) {
         return fc_channel_add_corruption(w.ctx, w.channel, static_cast<int>(w.given.whole(0, 0)),
                                          static_cast<int>(w.given.whole(1, 0)));
     }},
    {{"field", nullptr, {kApply, kType, kFieldByte, kBigEndian, kLength}, true}, arm_field},
    {{"truncate", nullptr, {whole("bytes", "n", "that are left", 0)}, false},
     [](const Wanted &w) {
         return fc_channel_add_truncate(w.ctx, w.channel,
                                        static_cast<std::size_t>(w.given.whole(0, 0)));
     }},
    {{"extend",
      nullptr,
      {whole("count", "n", "of bytes", 0),
       optional(whole("byte", nullptr, "their value; 0", 0, 255))},
      false},
     [](const Wanted &w) {
         return fc_channel_add_extend(w.ctx, w.channel,
                                      static_cast<std::size_t>(w.given.whole(0, 0)),
                                      static_cast<unsigned char>(w.given.whole(1, 0)));
     }},
    {{"drop", nullptr, {optional(whole("count", "packets,n", "of packets; all"))}, false},
     [](const Wanted &w) { return fc_channel_add_drop(w.ctx, w.channel, w.given.whole(0, kAll)); }},
    {{"repeat", nullptr, {whole("count", "packets,n", "of copies")}, false},
     [](const Wanted &w) { return fc_channel_add_repeat(w.ctx, w.channel, w.given.whole(0, 0)); }},
    {{"lose", nullptr, {}, false},
     [](const Wanted &w) { return fc_channel_add_lose(w.ctx, w.channel); }},
    {{"repeat_last", nullptr, {}, false},
     [](const Wanted &w) { return fc_channel_add_repeat_last(w.ctx, w.channel); }},
    {{"insert",
      nullptr,
      {text("data", "packet", "the packet, in hexadecimal"),
       optional(whole("times", "n", "at most; 1"))},
      false},
     arm_insert},
    {{"masquerade", nullptr, {text("from", nullptr, "a channel")}, false},
     [](const Wanted &w) { return fc_channel_add_masquerade(w.ctx, w.channel, w.given.text(0)); }},
    {{"resequence", nullptr, {whole("position", "k", "0 is the head")}, false},
     [](const Wanted &w) {
         return fc_channel_add_resequence(w.ctx, w.channel, w.given.whole(0, 0));
     }},
    {{"block_get", nullptr, {}, false},
     [](const Wanted &w) { return fc_channel_add_block_get(w.ctx, w.channel); }},
    {{"delay_gets", nullptr, {whole("gets", "n", "until it can be seen")}, false},
     [](const Wanted &w) { return fc_channel_add_delay(w.ctx, w.channel, w.given.whole(0, 0)); }},
    {{"delay_time", nullptr, {whole("ns", "t", "until it can be seen")}, false},
     [](const Wanted &w) {
         return fc_channel_add_delay_time(w.ctx, w.channel, w.given.whole(0, 0));
     }},
    {{"misroute", nullptr, {text("to", nullptr, "a channel")}, false},
     [](const Wanted &w) { return fc_channel_add_misroute(w.ctx, w.channel, w.given.text(0)); }},
    {{"asymmetric", nullptr, {kApply, kReceivers, kType, kFieldByte, kBigEndian, kLength}, true},
     arm_asymmetric},
    {{"subset", nullptr, {kReceivers}, false}, arm_subset},
    {{"block_put", nullptr, {}, false},
     [](const Wanted &w) { return fc_channel_add_block_put(w.ctx, w.channel); }},
    {{"delay",
      nullptr,
      {optional(whole("gets", "n", "until it can be seen; or ns")),
       optional(whole("ns", "t", "until it can be seen; or gets"))},
      false},
     arm_delay},
};

constexpr int kModelCount = sizeof kModels / sizeof *kModels;

} // namespace

const NamedModel *channel_model_at(int index) {
    return index >= 0 && index < kModelCount ? &kModels[index].named : nullptr;
}

fc_fault_id arm_channel_model(fc_context *ctx, const char *channel, const char *name,
                              const fc_argument *arguments, std::size_t count) {
    const auto refuse = [&](const Text &why) {
        return add_channel_fault(context_of(ctx), channel, {}, FC_E_ARG, why.c_str());
    };
    const int index = find_model(channel_model_at, name);
    if (index < 0)
        return refuse(format("there is no model %s of channels", quoted(name).c_str()));
    const ChannelEntry &entry = kModels[index];
    const NamedArguments unsorted(arguments, count);
    NamedArguments given = unsorted;
    Text why;
    if (given.read(entry.named, nullptr, &why) != FC_OK)
        return refuse(why);
    return entry.arm({ctx, channel, entry.named, given, unsorted});
}

} // namespace fc
