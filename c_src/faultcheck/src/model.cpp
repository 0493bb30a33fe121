#include "model.h"

#include <cmath>

namespace fc {

namespace {

struct Verdict {
    int code;
    const char *why;
};
constexpr Verdict kGood{FC_OK, ""};

Verdict expect(bool good, const char *why) {
    return good ? kGood : Verdict{FC_E_ARG, why};
}

bool is_number(double value) {
    return !std::isnan(value);
}

Verdict check(const Model &model) {
    const double a = model.a;
    const double b = model.b;
    switch (model.kind) {
    case FC_BITFLIP:
        return model.n >= 0 ? kGood : Verdict{FC_E_BIT, "the bit is below 0"};
    case FC_STUCK_BIT:
        if (model.n < 0)
            return {FC_E_BIT, "the bit is below 0"};
        return expect(a == 0 || a == 1, "a bit is stuck at 0 or 1");
    case FC_BITFLIP_RANDOM:
    case FC_STUCK:
    case FC_AMPLIFICATION:
    case FC_OFFSET:
    case FC_SET_TO:
        return kGood;
    case FC_NOISE_UNIFORM:
    case FC_NOISE_GAUSS:
        return expect(is_number(a), "the amplitude is not a number");
    case FC_RANDOM_OFFSET:
    case FC_SATURATE:
        return expect(a <= b, "the lower limit must not be above the upper one");
    case FC_HELD_OFFSET:
        return expect(a <= b && model.n >= 1, "the lower limit must not be above the upper one, "
                                              "and the time be at least 1 ns");
    case FC_DRIFT:
    case FC_DRIFT_TIMED:
        return expect(is_number(a) && b >= 0, "the rate must be a number and the limit >= 0");
    case FC_RAMP:
    case FC_OSCILLATE:
        return expect(is_number(a) && model.n >= 1,
                      "the value must be a number and the calls >= 1");
    case FC_DELAY:
        return expect(model.n >= 0, "the number of calls is below 0");
    case FC_QUANTISE:
        return expect(a > 0, "the step must be above 0");
    case FC_DEAD_ZONE:
        return expect(is_number(a) && is_number(b), "centre and width must be numbers");
    case FC_DROPOUT:
        return expect(a >= 0 && a <= 1 && model.n >= FC_HOLD && model.n <= FC_NAN,
                      "the probability must be 0..1 and the mode FC_HOLD, FC_ZERO or FC_NAN");
    case FC_SPIKE:
        return expect(a >= 0 && a <= 1 && is_number(b),
                      "the probability must be 0..1 and the height a number");
    }
    return {FC_E_ARG, "there is no such model"};
}

} // namespace

int check_model(const Model &model, const char **why) {
    const Verdict verdict = check(model);
    *why = verdict.why;
    return verdict.code;
}

} // namespace fc
