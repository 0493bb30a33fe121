/* state_messages.cpp: reads the simulation through csim.h. */
#include "state_messages.hpp"

#include <cmath>
#include <limits>
#include <vector>

namespace coptersim_stream {
namespace {

constexpr double radians_per_degree = 0.017453292519943295;
/* A lasting command of so much tilts by so many degrees. */
constexpr double command_of_tilt = 0.609, tilt_degrees = 15;

float seconds(std::uint64_t us) {
    return rounded(static_cast<double>(us) / 1e6);
}

void put(float (&to)[3], double x, double y, double z) {
    to[0] = rounded(x);
    to[1] = rounded(y);
    to[2] = rounded(z);
}

/* Calls read(sim, copter, list, count) until the list is large enough. */
template <class T, class F> std::vector<T> list_of(const csim *sim, std::int32_t copter, F read) {
    std::vector<T> list;
    std::size_t count = 0;
    int code = read(sim, copter, nullptr, &count);
    while (code == CSIM_OK || code == CSIM_E_SPACE) {
        list.resize(count);
        code = read(sim, copter, list.data(), &count);
        if (code == CSIM_OK) {
            list.resize(count);
            return list;
        }
    }
    return {};
}

std::set<std::int32_t> collided_copters(const csim *sim) {
    std::set<std::int32_t> ids;
    auto read = [](const csim *s, std::int32_t, csim_collision *list, std::size_t *count) {
        return csim_collisions(s, list, count);
    };
    for (const csim_collision &c : list_of<csim_collision>(sim, 0, read)) {
        ids.insert(c.id);
        if (c.kind == CSIM_COPTER) {
            ids.insert(c.other);
        }
    }
    return ids;
}

/* The radius is the same for all unless it follows the error of the position. */
class comfort_radius {
  public:
    explicit comfort_radius(const csim *sim) : sim_(sim) {
        double gain = 0;
        csim_get(sim, "comfort_radius", &radius_);
        csim_get(sim, "comfort_error_gain", &gain);
        own_ = gain != 0;
    }
    double of(std::int32_t copter) const {
        if (!own_) {
            return radius_;
        }
        std::vector<csim_ldm_entry> entries = list_of<csim_ldm_entry>(sim_, copter, csim_ldm);
        return entries.empty() ? radius_ : entries.front().along;
    }

  private:
    const csim *sim_;
    double radius_ = 0;
    bool own_ = false;
};

viz::ellipse ellipse_of(const csim_ldm_entry &e, std::uint64_t now,
                        const std::map<std::int32_t, std::int32_t> &line_places) {
    viz::ellipse ellipse;
    bool line = e.kind == CSIM_ENTRY_LINE;
    ellipse.about = line ? line_places.at(e.id) : e.id;
    ellipse.kind = line ? 1 : 0;
    ellipse.overlap = e.overlap ? 1 : 0;
    ellipse.x = rounded(e.cx);
    ellipse.y = rounded(e.cy);
    ellipse.rx = rounded(e.along);
    ellipse.ry = rounded(e.across);
    ellipse.theta = radians(e.angle);
    /* A message whose clock runs ahead has a negative age. */
    bool ahead = e.stamp_us > now;
    ellipse.age = line ? 0 : ahead ? -seconds(e.stamp_us - now) : seconds(now - e.stamp_us);
    return ellipse;
}

} // namespace

float rounded(double x) {
    if (std::isnan(x)) {
        return std::numeric_limits<float>::quiet_NaN();
    }
    if (std::fabs(x) > std::numeric_limits<float>::max()) {
        float infinity = std::numeric_limits<float>::infinity();
        return x > 0 ? infinity : -infinity;
    }
    return static_cast<float>(x);
}

float radians(double degrees) {
    return rounded(degrees * radians_per_degree);
}

viz::frame frame_of(const csim *sim, std::int32_t run, std::int32_t seq,
                    const std::set<std::int32_t> &faulted_copters) {
    csim_columns_view real, belief;
    csim_columns(sim, CSIM_TRUE, &real);
    csim_columns(sim, CSIM_PERCEIVED, &belief);
    const std::set<std::int32_t> in_collision = collided_copters(sim);
    const comfort_radius comfort(sim);
    viz::frame frame;
    frame.t_us = static_cast<std::int64_t>(csim_time(sim));
    frame.run = run;
    frame.seq = seq;
    frame.n = real.count;
    frame.objects.resize(static_cast<std::size_t>(real.count));
    for (int i = 0; i < real.count; i++) {
        viz::object &o = frame.objects[static_cast<std::size_t>(i)];
        o.id = real.id[i];
        o.kind = 0;
        o.flags = static_cast<std::int8_t>((in_collision.count(o.id) != 0 ? collided : 0) |
                                           (real.override_active[i] != 0 ? avoiding : 0) |
                                           (faulted_copters.count(o.id) != 0 ? faulted : 0));
        put(o.pos, real.px[i], real.py[i], real.pz[i]);
        put(o.vel, real.vx[i], real.vy[i], 0);
        o.yaw = radians(real.yaw[i]);
        o.roll = radians(real.roll[i]);
        o.pitch = radians(real.pitch[i]);
        put(o.pos_est, belief.px[i], belief.py[i], belief.pz[i]);
        put(o.vel_est, belief.vx[i], belief.vy[i], 0);
        o.comfort = rounded(comfort.of(o.id));
        o.steer[0] = radians(real.set_roll[i] / command_of_tilt * tilt_degrees);
        o.steer[1] = radians(real.set_pitch[i] / command_of_tilt * tilt_degrees);
    }
    return frame;
}

viz::risk risk_of(const csim *sim, std::int32_t run, std::int32_t observer,
                  const std::map<std::int32_t, std::int32_t> &line_places) {
    viz::risk risk;
    std::uint64_t now = csim_time(sim);
    risk.t_us = static_cast<std::int64_t>(now);
    risk.run = run;
    risk.observer = observer;
    for (const csim_ldm_entry &e : list_of<csim_ldm_entry>(sim, observer, csim_ldm)) {
        if (e.kind != CSIM_ENTRY_COMFORT) {
            risk.ellipses.push_back(ellipse_of(e, now, line_places));
        }
    }
    risk.n = static_cast<std::int32_t>(risk.ellipses.size());
    return risk;
}

viz::ranges ranges_of(const csim *sim, std::int32_t run, std::int32_t copter) {
    viz::ranges ranges;
    ranges.t_us = static_cast<std::int64_t>(csim_time(sim));
    ranges.run = run;
    ranges.object = copter;
    for (const csim_range &r : list_of<csim_range>(sim, copter, csim_ranges)) {
        viz::range range;
        range.anchor = r.anchor;
        range.measured = rounded(r.measured);
        range.expected = rounded(r.expected);
        range.used = r.used ? 1 : 0;
        ranges.items.push_back(range);
    }
    ranges.n = static_cast<std::int32_t>(ranges.items.size());
    return ranges;
}

} // namespace coptersim_stream
