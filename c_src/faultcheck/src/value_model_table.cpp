// The models of probes by name: which parameter is which number of an fc_model.
#include "named.h"

#include <cmath>
#include <cstring>

namespace fc {

namespace {

enum class Slot { a, b, n, mode };

constexpr NamedParameter kLimit = optional(number("limit", nullptr, "the largest drift; none"));
constexpr NamedParameter kMode = text("mode", nullptr, "hold, zero or nan");
constexpr NamedParameter kBit = whole("bit", "b", "0 is the least significant");
constexpr NamedParameter kLow = number("low", "lo", "the lower limit");
constexpr NamedParameter kHigh = number("high", "hi", "the upper limit");
constexpr NamedParameter kProbability = number("probability", "p", "of each affected call, 0..1");

struct ValueModel {
    NamedModel named;
    Slot slots[3]; // of the parameters
};

// In the order of fc_model_kind.
constexpr ValueModel kModels[] = {
    {{"bitflip", nullptr, {kBit}, false}, {Slot::n}},
    {{"bitflip_random", nullptr, {}, false}, {}},
    {{"stuck", "stuck_to_current", {}, false}, {}},
    {{"stuck_bit", nullptr, {kBit, whole("value", "v", "0 or 1", 0, 1)}, false},
     {Slot::n, Slot::a}},
    {{"amplification", nullptr, {number("value", "factor,k", "the factor")}, false}, {Slot::a}},
    {{"offset", nullptr, {number("value", "constant,c", "what is added")}, false}, {Slot::a}},
    {{"set_to", nullptr, {number("value", "v", "the new value")}, false}, {Slot::a}},
    {{"noise_uniform", nullptr, {number("amplitude", "a", "the largest noise")}, false}, {Slot::a}},
    {{"noise_gauss", nullptr, {number("deviation", "s", "the standard deviation")}, false},
     {Slot::a}},
    {{"random_offset", nullptr, {kLow, kHigh}, false}, {Slot::a, Slot::b}},
    {{"drift", nullptr, {number("rate", "r", "by each affected call"), kLimit}, false},
     {Slot::a, Slot::b}},
    {{"drift_timed", nullptr, {number("rate", "r", "by each second"), kLimit}, false},
     {Slot::a, Slot::b}},
    {{"ramp",
      nullptr,
      {number("value", "v", "at the end"), whole("calls", "n", "until then")},
      false},
     {Slot::a, Slot::n}},
    {{"delay", nullptr, {whole("calls", "n", "by how many affected calls")}, false}, {Slot::n}},
    {{"quantise", nullptr, {number("step", "q", "above 0")}, false}, {Slot::a}},
    {{"dead_zone",
      nullptr,
      {number("centre", "c", "what is given"), number("width", "w", "on either side")},
      false},
     {Slot::a, Slot::b}},
    {{"saturate", nullptr, {kLow, kHigh}, false}, {Slot::a, Slot::b}},
    {{"oscillate",
      nullptr,
      {number("amplitude", "a", "of the sine"), whole("calls", "n", "of a period")},
      false},
     {Slot::a, Slot::n}},
    {{"dropout", nullptr, {kProbability, kMode}, false}, {Slot::a, Slot::mode}},
    {{"spike", nullptr, {kProbability, number("height", "a", "up or down")}, false},
     {Slot::a, Slot::b}},
    {{"held_offset", nullptr, {kLow, kHigh, whole("ns", "hold_ns", "that one is held")}, false},
     {Slot::a, Slot::b, Slot::n}},
};

constexpr int kModelCount = sizeof kModels / sizeof *kModels;

// -1 for none of them.
int mode_of(const char *text) {
    constexpr const char *names[] = {"hold", "zero", "nan"};
    for (int mode = FC_HOLD; mode <= FC_NAN; ++mode)
        if (std::strcmp(names[mode], text) == 0)
            return mode;
    return -1;
}

void fill(const ValueModel &named, const NamedArguments &arguments, fc_model *model) {
    for (int place = 0; named.named.parameters[place].shown.name != nullptr; ++place) {
        switch (named.slots[place]) {
        case Slot::a:
            model->a = arguments.number(place, 0);
            break;
        case Slot::b: // only a limit may be left out
            model->b = arguments.number(place, HUGE_VAL);
            break;
        case Slot::n:
            model->n = arguments.whole(place, 0);
            break;
        case Slot::mode:
            model->n = mode_of(arguments.text(place));
            break;
        }
    }
}

} // namespace

const NamedModel *value_model_at(int index) {
    return index >= 0 && index < kModelCount ? &kModels[index].named : nullptr;
}

int read_value_model(const char *name, NamedArguments arguments, const NamedModel *outer,
                     fc_model *model, Text *why) {
    const int kind = find_model(value_model_at, name);
    if (kind < 0) {
        *why = format("there is no model %s of probes", quoted(name).c_str());
        return FC_E_ARG;
    }
    if (arguments.read(kModels[kind].named, outer, why) != FC_OK)
        return FC_E_ARG;
    *model = {kind, 0, 0, 0};
    fill(kModels[kind], arguments, model);
    return FC_OK;
}

} // namespace fc
