/* bisect.cpp: a coarse scan, then halving. */
#include "bisect.hpp"

#include <cmath>

namespace coptersim_run {
namespace {

constexpr int scan_steps = 16;
constexpr int halvings = 10;

class trials {
  public:
    trials(csim *sim, const csim_scenario::scenario &s, const std::string &name, const observer &o,
           std::FILE *to)
        : sim_(sim), scenario_(s), name_(name), observer_(o), to_(to) {
        whole_ = name == "its_div" || name == "anchor_div" || name == "seed" || name == "dt_us";
    }

    double rounded(double value) const {
        return whole_ ? std::round(value) : value;
    }

    /* Neighbours, with nothing to try between them. */
    bool adjacent(double a, double b) const {
        double middle = rounded(a + (b - a) / 2);
        return middle == a || middle == b;
    }

    bool survives(double value) {
        csim_scenario::scenario changed = scenario_;
        char text[64];
        std::snprintf(text, sizeof text, "%.17g", value);
        if (!csim_scenario::override_setting(changed, name_ + "=" + text, error)) {
            return false;
        }
        std::optional<csim_trace::trace> t = recorded_run(sim_, changed, observer_, error);
        if (!t || csim_status(sim_) == CSIM_STOPPED) {
            stopped = true;
            return false;
        }
        if (t->collision) {
            std::fprintf(to_, "%s=%-12.8g collision at %.3f s\n", name_.c_str(), value,
                         1e-6 * static_cast<double>(t->collision->t_us));
        } else {
            std::fprintf(to_, "%s=%-12.8g no collision\n", name_.c_str(), value);
        }
        std::fflush(to_);
        return !t->collision;
    }

    bool go_on() const {
        return error.empty() && !stopped;
    }

    std::string error;
    bool stopped = false; /* by request */

  private:
    csim *sim_;
    const csim_scenario::scenario &scenario_;
    std::string name_;
    const observer &observer_;
    std::FILE *to_;
    bool whole_;
};

} // namespace

bool bisect(csim *sim, const csim_scenario::scenario &s, const search_range &range,
            const observer &o, std::FILE *to, bisection &result, std::string &error) {
    trials t(sim, s, range.name, o, to);
    result = {};
    for (int i = 0; i <= scan_steps && t.go_on() && !result.smallest; i++) {
        double value = t.rounded(range.low + (range.high - range.low) * i / scan_steps);
        if (result.largest && value == *result.largest) {
            continue;
        }
        (t.survives(value) ? result.smallest : result.largest) = value;
    }
    for (int i = 0; i < halvings && result.smallest && result.largest && t.go_on(); i++) {
        if (t.adjacent(*result.largest, *result.smallest)) {
            break;
        }
        double middle = t.rounded(*result.largest + (*result.smallest - *result.largest) / 2);
        (t.survives(middle) ? result.smallest : result.largest) = middle;
    }
    error = t.error;
    return error.empty();
}

} // namespace coptersim_run
