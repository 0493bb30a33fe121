#include "named.h"

#include <cmath>
#include <cstring>

namespace fc {

namespace {

// names: between commas, or null.
bool is_one_of(const char *names, const char *asked) {
    const std::size_t length = std::strlen(asked);
    while (names != nullptr) {
        const char *end = std::strchr(names, ',');
        const std::size_t here =
            end == nullptr ? std::strlen(names) : static_cast<std::size_t>(end - names);
        if (here == length && std::strncmp(names, asked, length) == 0)
            return true;
        names = end == nullptr ? nullptr : end + 1;
    }
    return false;
}

bool is_called(const char *name, const char *other, const char *asked) {
    return std::strcmp(name, asked) == 0 || is_one_of(other, asked);
}

// -1 when the model has no such parameter.
int place_of(const NamedModel &model, const char *name) {
    for (int place = 0; place < kMostParameters; ++place) {
        const fc_parameter &parameter = model.parameters[place].shown;
        if (parameter.name == nullptr)
            return -1;
        if (is_called(parameter.name, parameter.other, name))
            return place;
    }
    return -1;
}

// What JSON and others cannot write as a number; false for any other text.
bool read_special(const char *text, double *value) {
    constexpr struct {
        const char *text;
        double value;
    } specials[] = {{"inf", HUGE_VAL}, {"-inf", -HUGE_VAL}, {"nan", NAN}};
    for (const auto &special : specials)
        if (std::strcmp(special.text, text) == 0) {
            *value = special.value;
            return true;
        }
    return false;
}

int refuse(Text *why, const Text &reason) {
    *why = reason;
    return FC_E_ARG;
}

int refuse_unknown(const NamedModel &model, const char *name, Text *why) {
    Text known = format("%s", "");
    for (const NamedParameter &parameter : model.parameters)
        if (parameter.shown.name != nullptr)
            known = format("%s%s%s", known.c_str(), known.chars[0] == '\0' ? ", but " : ", ",
                           parameter.shown.name);
    return refuse(why, format("model %s has no parameter %s%s", model.name, quoted(name).c_str(),
                              known.c_str()));
}

int check_kind(const NamedParameter &parameter, const fc_argument &argument, Text *why) {
    const char *name = parameter.shown.name;
    const double number = argument.number;
    switch (parameter.shown.takes) {
    case FC_TAKES_TEXT:
        return argument.text != nullptr
                   ? FC_OK
                   : refuse(why, format("%s must be a text: %s", name, parameter.shown.text));
    case FC_TAKES_WHOLE:
        if (argument.text == nullptr && number == std::trunc(number) && number >= parameter.least &&
            number <= parameter.most)
            return FC_OK;
        if (parameter.most == kMostWhole)
            return refuse(why, format("%s must be a whole number", name));
        return refuse(why, format("%s must be a whole number %.0f..%.0f", name, parameter.least,
                                  parameter.most));
    default:
        double special;
        return argument.text == nullptr || read_special(argument.text, &special)
                   ? FC_OK
                   : refuse(why, format("%s must be a number, inf, -inf or nan", name));
    }
}

} // namespace

int NamedArguments::read(const NamedModel &model, const NamedModel *outer, Text *why) {
    if (all_ == nullptr && count_ > 0)
        return refuse(why, format("the arguments are NULL"));
    for (std::size_t at = 0; at < count_; ++at) {
        const char *name = all_[at].name == nullptr ? "" : all_[at].name;
        const int place = place_of(model, name);
        if (place < 0) {
            if (model.applies || (outer != nullptr && place_of(*outer, name) >= 0))
                continue;
            return refuse_unknown(model, name, why);
        }
        if (given_[place] != nullptr)
            return refuse(why, format("%s is given twice", model.parameters[place].shown.name));
        if (check_kind(model.parameters[place], all_[at], why) != FC_OK)
            return FC_E_ARG;
        given_[place] = &all_[at];
    }
    for (int place = 0; place < kMostParameters; ++place) {
        const fc_parameter &parameter = model.parameters[place].shown;
        if (parameter.name != nullptr && parameter.required && given_[place] == nullptr)
            return refuse(
                why, format("model %s needs %s: %s", model.name, parameter.name, parameter.text));
    }
    return FC_OK;
}

double NamedArguments::number(int place, double otherwise) const {
    if (!has(place))
        return otherwise;
    double value = given_[place]->number;
    if (given_[place]->text != nullptr)
        read_special(given_[place]->text, &value);
    return value;
}

int find_model(const NamedModel *(*at)(int), const char *name) {
    for (int index = 0; name != nullptr && at(index) != nullptr; ++index)
        if (is_called(at(index)->name, at(index)->other, name))
            return index;
    return -1;
}

const char *name_of_model(int kind) {
    return value_model_at(kind)->name;
}

const char *name_of_model(ChannelModelKind kind) {
    return channel_model_at(static_cast<int>(kind))->name;
}

} // namespace fc
