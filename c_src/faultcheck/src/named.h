// Models and their parameters by name.
#pragma once

#include "channel_model.h"
#include "fc.h"
#include "report.h"

#include <cstddef>
#include <cstdint>

namespace fc {

struct NamedParameter {
    fc_parameter shown;
    double least; // FC_TAKES_WHOLE
    double most;
};

constexpr int kMostParameters = 6;
constexpr double kMostWhole = 0x1p53; // beyond, not every whole number is a double

// Parameters that must be given.
constexpr NamedParameter number(const char *name, const char *other, const char *text) {
    return {{name, other, FC_TAKES_NUMBER, true, text}, 0, 0};
}
constexpr NamedParameter whole(const char *name, const char *other, const char *text,
                               double least = -kMostWhole, double most = kMostWhole) {
    return {{name, other, FC_TAKES_WHOLE, true, text}, least, most};
}
constexpr NamedParameter text(const char *name, const char *other, const char *meaning) {
    return {{name, other, FC_TAKES_TEXT, true, meaning}, 0, 0};
}
constexpr NamedParameter optional(NamedParameter parameter) {
    parameter.shown.required = false;
    return parameter;
}

struct NamedModel {
    const char *name;
    const char *other;                          // more names, between commas, or null
    NamedParameter parameters[kMostParameters]; // those after the last one have no name
    bool applies; // a model of probes, which gets the arguments that are left
};

// What a caller gave, sorted to the parameters of one model.
class NamedArguments {
  public:
    NamedArguments(const fc_argument *arguments, std::size_t count)
        : all_(arguments), count_(count) {}

    // FC_OK, or FC_E_ARG with the reason. outer: the model that has taken some of them, or null.
    int read(const NamedModel &model, const NamedModel *outer, Text *why);

    // By the place of the parameter.
    bool has(int place) const {
        return given_[place] != nullptr;
    }
    double number(int place, double otherwise) const;
    std::int64_t whole(int place, std::int64_t otherwise) const {
        return has(place) ? static_cast<std::int64_t>(given_[place]->number) : otherwise;
    }
    const char *text(int place) const {
        return has(place) ? given_[place]->text : nullptr;
    }

  private:
    const fc_argument *all_;
    std::size_t count_;
    const fc_argument *given_[kMostParameters] = {};
};

// The index-th model in the order of fc_model_kind or ChannelModelKind, or null.
const NamedModel *value_model_at(int index);
const NamedModel *channel_model_at(int index);

// The index of the one that has that name, or -1.
int find_model(const NamedModel *(*at)(int), const char *name);

// FC_OK, or FC_E_ARG with the reason. The values may still be out of the model's range.
int read_value_model(const char *name, NamedArguments arguments, const NamedModel *outer,
                     fc_model *model, Text *why);

// Names for listings.
const char *name_of_model(int kind);
const char *name_of_model(ChannelModelKind kind);

} // namespace fc
