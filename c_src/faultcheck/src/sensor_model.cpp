#include "sensor_model.h"

#include "sine.h"

#include <algorithm>
#include <cmath>

namespace fc {

namespace {

double limit(double drift, double most) {
    return std::min(std::max(drift, -most), most);
}

double ramp(const Model &model, const SensorCall &call) {
    const auto n = static_cast<std::uint64_t>(model.n);
    const auto step = static_cast<double>(std::min(call.k + 1, n));
    return call.first + (model.a - call.first) * step / static_cast<double>(n);
}

double spike(const Model &model, RandomStream &random, double x) {
    if (!(random.unit() < model.a))
        return x;
    return random.below(2) == 0 ? x + model.b : x - model.b;
}

} // namespace

double compute_sensor(const Model &model, const SensorCall &call, RandomStream &random, double x) {
    switch (model.kind) {
    case FC_NOISE_UNIFORM:
        return x + model.a * (2 * random.unit() - 1);
    case FC_NOISE_GAUSS:
        return x + model.a * random.gauss();
    case FC_RANDOM_OFFSET:
        return x + model.a + (model.b - model.a) * random.unit();
    case FC_HELD_OFFSET:
        return x + model.a + (model.b - model.a) * call.unit;
    case FC_DRIFT:
        return x + limit(model.a * (static_cast<double>(call.k) + 1), model.b);
    case FC_DRIFT_TIMED:
        return x + limit(model.a * call.seconds, model.b);
    case FC_RAMP:
        return ramp(model, call);
    case FC_QUANTISE:
        return model.a * std::floor(x / model.a + 0.5);
    case FC_DEAD_ZONE:
        return std::fabs(x - model.a) < model.b ? model.a : x;
    case FC_SATURATE:
        return std::min(std::max(x, model.a), model.b);
    case FC_OSCILLATE:
        return x + model.a * sine_of_turn(call.k, static_cast<std::uint64_t>(model.n));
    case FC_SPIKE:
        return spike(model, random, x);
    default:
        return x;
    }
}

} // namespace fc
