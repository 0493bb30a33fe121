// sensor_models.cpp: how well does a filter bear faulty sensors?
//
// An alpha-beta filter tracks the height of a climbing aircraft while its altimeter suffers, one
// after the other, from every kind of sensor fault. Each context has its own faults and random
// streams, so campaigns may run side by side; the seed makes each repeatable.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fc.h>
#include <functional>
#include <iomanip>
#include <iostream>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// ---- the program under test ----

class AlphaBetaFilter {
  public:
    explicit AlphaBetaFilter(double height_m) : height_m_(height_m) {}

    double update(double measured_m, double dt_s) {
        height_m_ += climb_mps_ * dt_s;
        double residual = measured_m - height_m_;
        height_m_ += 0.2 * residual;
        climb_mps_ += 0.02 / dt_s * residual;
        return height_m_;
    }

  private:
    double height_m_;
    double climb_mps_ = 0;
};

// ---- the test ----

using Context = std::unique_ptr<fc_context, decltype(&fc_free)>;

Context new_context(std::uint64_t seed) {
    fc_options options = FC_OPTIONS_INIT;
    options.seed = seed;
    Context made(fc_new(&options), fc_free);
    if (!made) {
        throw std::bad_alloc();
    }
    return made;
}

using Arm = std::function<fc_fault_id(fc_context *, const char *)>;

struct Fault {
    std::string name;
    Arm arm;
};

const std::vector<Fault> &faults() {
    static const std::vector<Fault> all = {
        {"offset by 5 m", [](auto *c, auto *id) { return fc_add_offset(c, id, 5); }},
        {"gain 2 % too high", [](auto *c, auto *id) { return fc_add_amplification(c, id, 1.02); }},
        {"drift of 0.1 m a sample, up to 20 m",
         [](auto *c, auto *id) { return fc_add_drift(c, id, 0.1, 20); }},
        {"gaussian noise of 2 m", [](auto *c, auto *id) { return fc_add_noise_gauss(c, id, 2); }},
        {"resolution of 10 m", [](auto *c, auto *id) { return fc_add_quantise(c, id, 10); }},
        {"10 samples late", [](auto *c, auto *id) { return fc_add_delay(c, id, 10); }},
        {"every fifth sample reads 0",
         [](auto *c, auto *id) { return fc_add_dropout(c, id, 0.2, FC_ZERO); }},
        {"spikes of 50 m, one in twenty",
         [](auto *c, auto *id) { return fc_add_spike(c, id, 0.05, 50); }},
        {"stuck", [](auto *c, auto *id) { return fc_add_stuck(c, id); }},
    };
    return all;
}

// The largest error in metres, and how long it is above a metre once the fault has gone.
struct Outcome {
    double worst_m = 0;
    int recovery_samples = 0;
};

// The fault acts on samples 100 to 199 of 300.
Outcome fly(const Fault *fault) {
    constexpr double dt_s = 0.1;
    Context context = new_context(7);
    if (fault != nullptr) {
        fc_fault_id id = fault->arm(context.get(), "altimeter");
        if (id < 0) {
            throw std::runtime_error(fault->name + ": " + fc_last_error_text());
        }
        fc_trigger_after(context.get(), id, 100);
        fc_trigger_duration(context.get(), id, 100);
    }
    AlphaBetaFilter filter(200);
    Outcome outcome;
    for (int sample = 0; sample < 300; sample++) {
        double true_m = 200 + 3 * dt_s * (sample + 1);
        double measured_m = true_m;
        fc_probe_f64(context.get(), "altimeter", &measured_m);
        double error_m = std::abs(filter.update(measured_m, dt_s) - true_m);
        if (sample >= 100) { // until then the filter finds the climb rate
            outcome.worst_m = std::max(outcome.worst_m, error_m);
        }
        if (sample >= 200 && error_m > 1) {
            outcome.recovery_samples = sample - 199;
        }
    }
    return outcome;
}

void print(const std::string &name, const Outcome &outcome) {
    std::cout << std::left << std::setw(38) << name << std::right << std::fixed
              << std::setprecision(1) << std::setw(9) << outcome.worst_m << std::setw(19)
              << outcome.recovery_samples << '\n';
}

} // namespace

int main() {
    try {
        std::cout << "error of the filter                    worst, m  recovery, samples\n";
        print("no fault", fly(nullptr));
        for (const Fault &fault : faults()) {
            print(fault.name, fly(&fault));
        }
    } catch (const std::exception &error) {
        std::cerr << "sensor_models: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
