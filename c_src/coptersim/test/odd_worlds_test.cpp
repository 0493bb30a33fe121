// Coincident copters, lines without length, absurd faults, contacts that last.
#include "check.h"
#include "csim.h"
#include "fc.h"

#include <cmath>
#include <cstddef>
#include <initializer_list>

namespace {

bool is_finite(csim *sim, int copter, csim_view view) {
    csim_state s;
    csim_get_state(sim, copter, view, &s);
    return std::isfinite(s.px + s.py + s.vx + s.vy + s.roll + s.pitch + s.yaw);
}

std::size_t collisions(const csim *sim) {
    std::size_t count = 0;
    csim_collisions(sim, nullptr, &count);
    return count;
}

void coincident_copters_get_a_command_of_zero() {
    csim *sim = csim_new(nullptr);
    csim_set(sim, "halt_on_collision", 0);
    csim_add_copter(sim, 0, 1, 1, 0);
    csim_add_copter(sim, 1, 1, 1, 0);
    csim_command(sim, 1, 1, 1, 0, 0);
    csim_run(sim, 2, 5000, 1, 20);
    csim_station station;
    csim_override(sim, 1, &station);
    CHECK(station.active);
    CHECK_BITS(station.roll, 0);
    CHECK(is_finite(sim, 0, CSIM_TRUE) && is_finite(sim, 1, CSIM_TRUE));
    csim_free(sim);
}

void a_line_without_length_is_a_point() {
    csim *sim = csim_new(nullptr);
    csim_add_line(sim, 3, 2, 0, 2, 0);
    csim_add_copter(sim, 0, 1.7, 0, 0);
    csim_run(sim, 1, 5000, 20, 20);
    csim_collision hit;
    std::size_t count = 1;
    CHECK_INT(csim_collisions(sim, &hit, &count), CSIM_OK);
    CHECK(count == 1 && hit.kind == CSIM_TERRAIN && hit.other == 3);
    CHECK_BITS(hit.x, 2);
    CHECK_INT(csim_run(sim, 1, 5000, 20, 20), CSIM_E_HALTED);
    csim_free(sim);
}

// In the course of 100 steps nothing that copter 0 believes or sends reaches copter 1.
void absurd_values_stay_with_their_copter() {
    const char *const probes[] = {"PxId0",  "PyId0",         "RollId0",      "PitchId0",
                                  "YawId0", "RangeId0Anch2", "AnchXId0Anch2"};
    for (const double value : {HUGE_VAL, -HUGE_VAL, double(NAN), 1e308, -1e200, 1e17}) {
        for (const char *probe : probes) {
            csim *sim = csim_new(nullptr);
            for (int i = 0; i < 4; i++)
                csim_add_anchor(sim, i, i < 2 ? -5 : 5, i % 2 ? -5 : 5, 1);
            csim_add_copter(sim, 0, 0, 0, 0);
            csim_add_copter(sim, 1, 3, 0, 0);
            csim_add_line(sim, 0, -9, -9, 9, -9);
            fc_add_set_to(csim_faults(sim), probe, value);
            CHECK_INT(csim_run(sim, 100, 5000, 5, 2), CSIM_OK);
            CHECK(is_finite(sim, 1, CSIM_TRUE) && is_finite(sim, 1, CSIM_PERCEIVED));
            CHECK(is_finite(sim, 0, CSIM_TRUE));
            csim_free(sim);
        }
    }
}

void a_contact_counts_once() {
    csim *sim = csim_new(nullptr);
    csim_set(sim, "halt_on_collision", 0);
    csim_add_copter(sim, 4, 0, 0, 0);
    csim_add_copter(sim, 2, 0.5, 0, 0);
    csim_run(sim, 50, 5000, 20, 20);
    CHECK_INT(collisions(sim), 1);
    csim_state state;
    csim_get_state(sim, 4, CSIM_TRUE, &state);
    state.px = 50;
    csim_set_state(sim, 4, CSIM_TRUE, &state);
    csim_run(sim, 1, 5000, 20, 20);
    CHECK_INT(collisions(sim), 1);
    state.px = 0.5;
    csim_set_state(sim, 4, CSIM_TRUE, &state);
    csim_run(sim, 1, 5000, 20, 20);
    CHECK_INT(collisions(sim), 2);
    csim_resume(sim);
    csim_run(sim, 1, 5000, 20, 20);
    CHECK_INT(collisions(sim), 0);
    csim_free(sim);
}

// (3, 0) and (3, 4): a gap of 5 - 0.8; both fly at each other with 1 m/s: 4 / (2 * 9) to stop.
void closeness_is_measured_at_ends_of_steps() {
    for (const csim_closeness_kind kind : {CSIM_GAP, CSIM_STOP, CSIM_LATE}) {
        csim *sim = csim_new(nullptr);
        csim_set(sim, "drag", 1);
        csim_add_copter(sim, 1, 0, 0, 0);
        csim_add_copter(sim, 2, 5, 0, 0);
        csim_state state;
        csim_get_state(sim, 1, CSIM_TRUE, &state);
        state.vx = 1;
        csim_set_state(sim, 1, CSIM_TRUE, &state);
        state.px = 5;
        state.vx = -1;
        csim_set_state(sim, 2, CSIM_TRUE, &state);
        csim_watch_closeness(sim, kind, 10000);
        csim_run(sim, 1, 5000, 20, 20);
        csim_closeness closest;
        csim_closest(sim, &closest);
        const double gap = 5 - 0.01 - 0.8;
        const double want = kind == CSIM_GAP    ? gap
                            : kind == CSIM_STOP ? gap - 4.0 / 18
                                                : gap + 0.15;
        CHECK(std::fabs(closest.value - want) < 1e-12);
        CHECK(closest.kind == CSIM_COPTER && closest.id == 1 && closest.other == 2);
        CHECK_INT(closest.t_us, 5000);
        csim_free(sim);
    }
}

// Nobody hears copter 0 any more a second after it was removed.
void what_others_know_expires() {
    csim *sim = csim_new(nullptr);
    csim_add_copter(sim, 0, 0, 0, 0);
    csim_add_copter(sim, 1, 5, 0, 0);
    csim_run(sim, 20, 5000, 20, 20);
    csim_remove_copter(sim, 0);
    std::size_t count = 0;
    csim_run(sim, 200, 5000, 20, 20);
    csim_ldm(sim, 1, nullptr, &count);
    CHECK_INT(count, 2); // its own zone, and copter 0, just a second old
    csim_run(sim, 1, 5000, 20, 20);
    csim_ldm(sim, 1, nullptr, &count);
    CHECK_INT(count, 1);
    csim_free(sim);
}

// A packet with a wrong bit anywhere is discarded with a checksum, and used without.
void protection_discards_what_was_altered() {
    for (int protect = 0; protect < 3; protect++) {
        csim *sim = csim_new(nullptr);
        csim_set(sim, "protect", protect);
        csim_add_copter(sim, 0, 0, 0, 0);
        csim_add_copter(sim, 1, 5, 0, 0);
        fc_channel_add_corruption(csim_faults(sim), "ITS_DATA0", 24, 0); // of py
        csim_run(sim, 40, 5000, 20, 20);
        std::size_t count = 0;
        csim_ldm(sim, 0, nullptr, &count);
        CHECK_INT(count, protect == 0 ? 2 : 1);
        fc_channel_remove_all_faults(csim_faults(sim));
        csim_run(sim, 20, 5000, 20, 20);
        csim_ldm(sim, 0, nullptr, &count);
        CHECK_INT(count, 2);
        csim_free(sim);
    }
}

// With messages lost and a limit to silence, a copter that flies stops.
void a_deaf_copter_stops() {
    for (const double silence : {0.0, 300000.0}) {
        csim *sim = csim_new(nullptr);
        csim_set(sim, "silence_us", silence);
        csim_add_copter(sim, 0, 0, 0, 0);
        csim_add_copter(sim, 1, 50, 0, 0);
        csim_command(sim, 0, 0, 0.3, 0, 0);
        csim_run(sim, 100, 5000, 20, 20);
        fc_channel_add_lose(csim_faults(sim), "ITS_DATA0");
        csim_run(sim, 1000, 5000, 20, 20);
        csim_state state;
        csim_get_state(sim, 0, CSIM_TRUE, &state);
        CHECK((std::fabs(state.vy) < 0.3) == (silence > 0));
        csim_free(sim);
    }
}

} // namespace

int main() {
    coincident_copters_get_a_command_of_zero();
    a_line_without_length_is_a_point();
    absurd_values_stay_with_their_copter();
    a_contact_counts_once();
    closeness_is_measured_at_ends_of_steps();
    what_others_know_expires();
    protection_discards_what_was_altered();
    a_deaf_copter_stops();
    return CHECK_RESULT();
}
