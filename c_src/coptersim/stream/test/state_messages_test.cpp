/* state_messages_test.cpp: units, flags, zones and contours, against values worked out by hand or
 * read through csim.h. */
#include "state_messages.hpp"

#include "check.h"

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

using namespace coptersim_stream;

namespace {

struct sim_free {
    void operator()(csim *sim) const {
        csim_free(sim);
    }
};
using owner = std::unique_ptr<csim, sim_free>;

owner new_sim() {
    return owner(csim_new(nullptr));
}

std::vector<csim_ldm_entry> ldm(const csim *sim, std::int32_t copter) {
    std::size_t count = 64;
    std::vector<csim_ldm_entry> entries(count);
    CHECK_INT(csim_ldm(sim, copter, entries.data(), &count), CSIM_OK);
    entries.resize(count);
    return entries;
}

void angles_are_radians_and_states_are_told_apart() {
    owner sim = new_sim();
    csim_add_copter(sim.get(), 7, 1.5, -2, 90);
    csim_state real{3, 4, 0.5, 0.25, -0.5, 18, -36, 180, 0, 0};
    csim_state belief{3.5, 4.5, 0.75, 1, 2, 0, 0, 0, 0, 0};
    CHECK_INT(csim_set_state(sim.get(), 7, CSIM_TRUE, &real), CSIM_OK);
    CHECK_INT(csim_set_state(sim.get(), 7, CSIM_PERCEIVED, &belief), CSIM_OK);
    viz::frame frame = frame_of(sim.get(), 3, 9, {});
    CHECK_INT(frame.t_us, 0);
    CHECK_INT(frame.run, 3);
    CHECK_INT(frame.seq, 9);
    CHECK_INT(frame.n, 1);
    const viz::object &o = frame.objects.at(0);
    CHECK_INT(o.id, 7);
    CHECK_INT(o.kind, 0);
    CHECK_INT(o.flags, 0);
    CHECK(o.pos[0] == 3.0F && o.pos[1] == 4.0F && o.pos[2] == 0.5F);
    CHECK(o.vel[0] == 0.25F && o.vel[1] == -0.5F && o.vel[2] == 0.0F);
    CHECK(o.pos_est[0] == 3.5F && o.pos_est[1] == 4.5F && o.pos_est[2] == 0.75F);
    CHECK(o.vel_est[0] == 1.0F && o.vel_est[1] == 2.0F && o.vel_est[2] == 0.0F);
    CHECK(o.roll == 0.314159265F);   /* pi / 10 */
    CHECK(o.pitch == -0.628318531F); /* -pi / 5 */
    CHECK(o.yaw == 3.141592654F);    /* pi */
}

void the_command_that_is_followed_is_a_tilt() {
    owner sim = new_sim();
    csim_add_copter(sim.get(), 0, 0, 0, 0);
    csim_command(sim.get(), 0, 0.609, -0.203, 0, 0);
    CHECK_INT(csim_run(sim.get(), 1, 5000, 20, 20), CSIM_OK);
    viz::frame frame = frame_of(sim.get(), 1, 0, {});
    CHECK(std::fabs(frame.objects[0].steer[0] - 0.261799388F) < 1e-7F);  /* 15 degrees */
    CHECK(std::fabs(frame.objects[0].steer[1] + 0.0872664626F) < 1e-7F); /* -5 degrees */
}

void flags_are_collided_avoiding_faulted() {
    owner sim = new_sim();
    csim_add_copter(sim.get(), 1, 0, 0, 0);
    csim_add_copter(sim.get(), 2, 0.5, 0, 0); /* closer than 0.8 m */
    csim_add_copter(sim.get(), 3, 50, 0, 0);
    csim_run(sim.get(), 1, 5000, 1, 1);
    CHECK_INT(csim_status(sim.get()), CSIM_COLLIDED);
    viz::frame frame = frame_of(sim.get(), 1, 0, {1, 3});
    CHECK_INT(frame.objects[0].flags & collided, collided);
    CHECK_INT(frame.objects[1].flags & collided, collided);
    CHECK_INT(frame.objects[2].flags, faulted);
    CHECK_INT(frame.objects[0].flags & faulted, faulted);
    CHECK_INT(frame.objects[1].flags & faulted, 0);
}

void a_copter_that_avoids_terrain_has_the_flag() {
    owner sim = new_sim();
    csim_add_line(sim.get(), 1, -1, 1, 1, 1); /* in its comfort zone, 1 m away */
    csim_add_copter(sim.get(), 0, 0, 0, 0);
    csim_add_copter(sim.get(), 1, 30, 30, 0);
    csim_run(sim.get(), 2, 5000, 1, 1);
    csim_station station;
    CHECK_INT(csim_override(sim.get(), 0, &station), CSIM_OK);
    CHECK(station.active);
    viz::frame frame = frame_of(sim.get(), 1, 0, {});
    CHECK_INT(frame.objects[0].flags, avoiding);
    CHECK_INT(frame.objects[1].flags, 0);
}

void terrain_marks_the_copter_that_met_it() {
    owner sim = new_sim();
    csim_add_line(sim.get(), 1, -1, 0.1, 1, 0.1); /* closer than 0.4 m to copter 0 */
    csim_add_copter(sim.get(), 0, 0, 0, 0);
    csim_add_copter(sim.get(), 1, 30, 30, 0);
    csim_run(sim.get(), 1, 5000, 1, 1);
    viz::frame frame = frame_of(sim.get(), 1, 0, {});
    CHECK_INT(frame.objects[0].flags & collided, collided);
    CHECK_INT(frame.objects[1].flags & collided, 0); /* its id is that of the line */
}

void the_comfort_zone_is_the_parameter_or_grows_with_the_error() {
    owner sim = new_sim();
    csim_add_anchor(sim.get(), 0, 10, 0, 1);
    csim_add_copter(sim.get(), 4, 0, 0, 0);
    CHECK_INT(csim_set(sim.get(), "comfort_radius", 1.25), CSIM_OK);
    CHECK(frame_of(sim.get(), 1, 0, {}).objects[0].comfort == 1.25F);
    CHECK_INT(csim_set(sim.get(), "comfort_error_gain", 2), CSIM_OK);
    csim_state belief;
    csim_get_state(sim.get(), 4, CSIM_PERCEIVED, &belief);
    belief.px = 0.5;
    csim_set_state(sim.get(), 4, CSIM_PERCEIVED, &belief);
    csim_run(sim.get(), 4, 5000, 1, 1);
    double own = ldm(sim.get(), 4).at(0).along;
    CHECK(own > 1.25);
    CHECK(frame_of(sim.get(), 1, 0, {}).objects[0].comfort == static_cast<float>(own));
}

void contours_are_the_local_dynamic_map_without_the_own_zone() {
    owner sim = new_sim();
    csim_add_line(sim.get(), 30, 0, -3, 0, 3); /* upright: 90 degrees */
    csim_add_line(sim.get(), 20, 5, 5, 9, 5);
    csim_add_copter(sim.get(), 1, -2, 0, 0);
    csim_add_copter(sim.get(), 5, -5, 0, 0);
    csim_run(sim.get(), 7, 5000, 5, 5);
    viz::risk risk = risk_of(sim.get(), 2, 1, {{20, 0}, {30, 1}});
    std::vector<csim_ldm_entry> entries = ldm(sim.get(), 1);
    CHECK_INT(risk.t_us, 35000);
    CHECK_INT(risk.run, 2);
    CHECK_INT(risk.observer, 1);
    CHECK_INT(risk.n, 3);
    CHECK_INT(static_cast<int>(entries.size()), 4);
    for (std::size_t i = 0; i < 3; i++) {
        const viz::ellipse &e = risk.ellipses.at(i);
        const csim_ldm_entry &from = entries.at(i + 1);
        CHECK_INT(e.overlap, from.overlap);
        CHECK(e.x == static_cast<float>(from.cx) && e.y == static_cast<float>(from.cy));
        CHECK(e.rx == static_cast<float>(from.along) && e.ry == static_cast<float>(from.across));
        CHECK(std::fabs(e.theta - from.angle * 3.14159265358979 / 180) < 1e-6);
    }
    CHECK_INT(risk.ellipses[0].kind, 0);
    CHECK_INT(risk.ellipses[0].about, 5);
    /* messages go out every 5 steps, so the latest is one of the steps before */
    double age = 1e-6 * (35000 - static_cast<double>(entries[1].stamp_us));
    CHECK(age >= 0 && age <= 0.035);
    CHECK(risk.ellipses[0].age == static_cast<float>(age));
    CHECK_INT(risk.ellipses[1].kind, 1);
    CHECK_INT(risk.ellipses[1].about, 0); /* line 20: the first of world.seg */
    CHECK_INT(risk.ellipses[2].about, 1);
    CHECK(risk.ellipses[2].age == 0.0F);
    CHECK(std::fabs(std::fabs(risk.ellipses[2].theta) - 1.5707963F) < 1e-6F ||
          risk.ellipses[2].rx == risk.ellipses[2].ry);
}

void nobody_has_no_contours_and_no_ranges() {
    owner sim = new_sim();
    CHECK_INT(risk_of(sim.get(), 1, -1, {}).n, 0);
    CHECK_INT(risk_of(sim.get(), 1, 8, {}).observer, 8);
    CHECK_INT(ranges_of(sim.get(), 1, 8).n, 0);
    CHECK_INT(frame_of(sim.get(), 1, 0, {}).n, 0);
}

void ranges_are_the_latest_samples() {
    owner sim = new_sim();
    csim_add_anchor(sim.get(), 9, 3, 4, 0.5); /* 5 m away at the same height as the copter */
    csim_add_copter(sim.get(), 0, 0, 0, 0);
    csim_run(sim.get(), 1, 5000, 1, 1);
    viz::ranges ranges = ranges_of(sim.get(), 1, 0);
    CHECK_INT(ranges.object, 0);
    CHECK_INT(ranges.n, 1);
    CHECK_INT(ranges.items.at(0).anchor, 9);
    CHECK(std::fabs(ranges.items[0].measured - 5.0F) < 1e-4F);
    CHECK(std::fabs(ranges.items[0].expected - 5.0F) < 1e-4F);
    CHECK_INT(ranges.items[0].used, 1);
}

void what_no_float_holds_is_infinite_or_nan() {
    CHECK(rounded(1e300) == std::numeric_limits<float>::infinity());
    CHECK(rounded(-1e300) == -std::numeric_limits<float>::infinity());
    CHECK(rounded(std::numeric_limits<double>::infinity()) ==
          std::numeric_limits<float>::infinity());
    CHECK(std::isnan(rounded(-std::numeric_limits<double>::quiet_NaN())));
    CHECK(!std::signbit(rounded(-std::numeric_limits<double>::quiet_NaN())));
    CHECK(rounded(0.1) == 0.1F);
}

} // namespace

int main() {
    angles_are_radians_and_states_are_told_apart();
    the_command_that_is_followed_is_a_tilt();
    flags_are_collided_avoiding_faulted();
    a_copter_that_avoids_terrain_has_the_flag();
    terrain_marks_the_copter_that_met_it();
    the_comfort_zone_is_the_parameter_or_grows_with_the_error();
    contours_are_the_local_dynamic_map_without_the_own_zone();
    nobody_has_no_contours_and_no_ranges();
    ranges_are_the_latest_samples();
    what_no_float_holds_is_infinite_or_nan();
    return CHECK_RESULT();
}
