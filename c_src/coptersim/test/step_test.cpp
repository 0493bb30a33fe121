// Steps of one and two copters against values calculated by hand or by mpmath.
#include "check.h"
#include "csim.h"

#include <cmath>
#include <cstdint>

namespace {

constexpr std::uint64_t kDt = 5000; // us
constexpr double kPi = 3.14159265358979323846;

double close_to(double a, double b) {
    return std::fabs(a - b) < 1e-12 * std::fmax(1, std::fabs(b));
}

csim_state state_of(csim *sim, int copter, csim_view view = CSIM_TRUE) {
    csim_state state;
    CHECK_INT(csim_get_state(sim, copter, view, &state), CSIM_OK);
    return state;
}

// roll = (0 + 250 dt) f, f = 0.995^5; the first step moves nothing, for it starts level.
void a_full_command_tilts_and_then_moves() {
    csim *sim = csim_new(nullptr);
    csim_add_copter(sim, 3, 1, 2, 0);
    csim_command(sim, 3, 1, 0, 0.5, 0);
    CHECK_INT(csim_run(sim, 1, kDt, 20, 20), CSIM_OK);
    const double f = std::pow(0.995, 5), roll = 1.25 * f;
    CHECK(close_to(state_of(sim, 3).roll, roll));
    CHECK(close_to(state_of(sim, 3).yaw, 0.375));
    CHECK_BITS(state_of(sim, 3).px, 1);
    CHECK_INT(csim_run(sim, 1, kDt, 20, 20), CSIM_OK);
    const double a = 9.82 * std::tan(roll * kPi / 180), yaw = 0.375 * kPi / 180, dt = 0.005;
    CHECK(close_to(state_of(sim, 3).px, 1 + dt * dt * a * std::cos(yaw) * 11 / 6));
    CHECK(close_to(state_of(sim, 3).py, 2 + dt * dt * a * std::sin(yaw) * 11 / 6));
    CHECK(close_to(state_of(sim, 3).vx, a * std::cos(yaw) * dt * std::pow(0.9, dt)));
    CHECK_INT(csim_time(sim), 2 * kDt);
    csim_free(sim);
}

void positive_pitch_accelerates_along_minus_y() {
    csim *sim = csim_new(nullptr);
    csim_add_copter(sim, 0, 0, 0, 90);
    csim_command(sim, 0, 0, 1, 0, 0);
    csim_run(sim, 100, kDt, 20, 20);
    CHECK(state_of(sim, 0).vx > 0.1); // -y of the body is +x of the world at a yaw of 90
    CHECK(std::fabs(state_of(sim, 0).vy) < 1e-12);
    csim_free(sim);
}

void belief_equals_truth_without_faults() {
    csim *sim = csim_new(nullptr);
    for (int i = 0; i < 4; i++) {
        csim_add_anchor(sim, i, i < 2 ? -8 : 8, i % 2 ? -5 : 5, 1);
        csim_add_copter(sim, i, 0.7 * i, -0.3 * i, 33 * i);
        csim_command(sim, i, 0.1 * i, -0.3, 0.2, 0);
    }
    csim_run(sim, 400, kDt, 20, 20);
    for (int i = 0; i < 4; i++) {
        const csim_state truth = state_of(sim, i), belief = state_of(sim, i, CSIM_PERCEIVED);
        CHECK_BITS(truth.px, belief.px);
        CHECK_BITS(truth.vy, belief.vy);
        CHECK_BITS(truth.roll, belief.roll);
    }
    csim_free(sim);
}

// At 1 m apart: w = 0, so q = (1 / 1.45)^2, |C| = 0.2 * 2 / q = 0.841 towards the other.
void two_that_are_near_each_other_part() {
    csim *sim = csim_new(nullptr);
    csim_add_copter(sim, 1, 0, 0, 0);
    csim_add_copter(sim, 2, 1, 0, 0);
    csim_run(sim, 1, kDt, 1, 20);
    csim_station station;
    csim_override(sim, 1, &station);
    CHECK(!station.active); // it hears copter 2 in the next step
    csim_override(sim, 2, &station);
    CHECK(station.active);
    CHECK(close_to(station.roll, 0.4 * 1.45 * 1.45));
    CHECK(close_to(1 + station.pitch, 1));
    csim_run(sim, 1, kDt, 1, 20);
    csim_override(sim, 1, &station);
    CHECK(station.active);
    CHECK(station.roll < 0);
    CHECK_INT(station.steps, 1);
    csim_free(sim);
}

// Anchors are used in the order 1, 0, for the index advances before its use; a wall of 3 m on the
// way is refused by the gate, and what was measured says so.
void measured_ranges_can_be_read() {
    csim *sim = csim_new(nullptr);
    csim_add_anchor(sim, 7, 3, 0, 0.5);
    csim_add_anchor(sim, 5, 0, 4, 0.5);
    csim_add_copter(sim, 1, 0, 0, 0);
    std::size_t count = 2;
    csim_range ranges[2];
    CHECK_INT(csim_ranges(sim, 1, ranges, &count), CSIM_OK);
    CHECK_INT(static_cast<long>(count), 0);
    fc_add_offset(csim_faults(sim), "RangeId1Anch7", 3.0);
    CHECK_INT(csim_run(sim, 2, kDt, 20, 1), CSIM_OK);
    count = 1;
    CHECK_INT(csim_ranges(sim, 1, ranges, &count), CSIM_E_SPACE);
    CHECK_INT(static_cast<long>(count), 2);
    CHECK_INT(csim_ranges(sim, 1, ranges, &count), CSIM_OK);
    CHECK_INT(ranges[0].anchor, 7);
    CHECK_BITS(ranges[0].measured, 6);
    CHECK_BITS(ranges[0].expected, 3);
    CHECK(!ranges[0].used && ranges[0].t_us == 2 * kDt);
    CHECK_INT(ranges[1].anchor, 5);
    CHECK_BITS(ranges[1].measured, 4);
    CHECK(ranges[1].used && ranges[1].t_us == kDt);
    CHECK_INT(csim_ranges(sim, 2, nullptr, &count), CSIM_E_ID);
    CHECK_INT(csim_ranges(sim, 1, nullptr, nullptr), CSIM_E_ARG);
    csim_free(sim);
}

// The pilot's until the avoidance takes over.
void the_command_that_is_followed_can_be_read() {
    csim *sim = csim_new(nullptr);
    csim_add_copter(sim, 1, 0, 0, 0);
    csim_command(sim, 1, 0.25, -0.5, 0, 0);
    CHECK_INT(csim_run(sim, 1, kDt, 20, 20), CSIM_OK);
    csim_columns_view view;
    CHECK_INT(csim_columns(sim, CSIM_TRUE, &view), CSIM_OK);
    CHECK_BITS(view.set_roll[0], 0.25);
    CHECK_BITS(view.set_pitch[0], -0.5);
    csim_free(sim);
}

} // namespace

int main() {
    a_full_command_tilts_and_then_moves();
    positive_pitch_accelerates_along_minus_y();
    belief_equals_truth_without_faults();
    measured_ranges_can_be_read();
    the_command_that_is_followed_can_be_read();
    two_that_are_near_each_other_part();
    return CHECK_RESULT();
}
