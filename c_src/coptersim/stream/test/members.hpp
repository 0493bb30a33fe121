/* members.hpp: the members of every message type by name, in the order of the folder lcm, for
 * programs that print, make or compare any message. A visitor has operator()(const char *name, T
 * &member)               a plain member or a fixed array count(const char *name, int32_t &n,
 * std::vector<T> &) before the array that it counts */
#ifndef CSIM_STREAM_MEMBERS_HPP
#define CSIM_STREAM_MEMBERS_HPP

#include "viz/ack.hpp"
#include "viz/case_info.hpp"
#include "viz/control.hpp"
#include "viz/event.hpp"
#include "viz/faults.hpp"
#include "viz/frame.hpp"
#include "viz/ranges.hpp"
#include "viz/risk.hpp"
#include "viz/status.hpp"
#include "viz/world.hpp"

namespace viz_test {

template <class V> void members(viz::object &m, V &v) {
    v("id", m.id), v("kind", m.kind), v("flags", m.flags);
    v("pos", m.pos), v("vel", m.vel), v("yaw", m.yaw), v("roll", m.roll), v("pitch", m.pitch);
    v("pos_est", m.pos_est), v("vel_est", m.vel_est), v("comfort", m.comfort), v("steer", m.steer);
}
template <class V> void members(viz::frame &m, V &v) {
    v("t_us", m.t_us), v("run", m.run), v("seq", m.seq);
    v.count("n", m.n, m.objects), v("objects", m.objects);
}
template <class V> void members(viz::ellipse &m, V &v) {
    v("about", m.about), v("kind", m.kind), v("overlap", m.overlap), v("x", m.x), v("y", m.y);
    v("rx", m.rx), v("ry", m.ry), v("theta", m.theta), v("age", m.age);
}
template <class V> void members(viz::risk &m, V &v) {
    v("t_us", m.t_us), v("run", m.run), v("observer", m.observer);
    v.count("n", m.n, m.ellipses), v("ellipses", m.ellipses);
}
template <class V> void members(viz::anchor &m, V &v) {
    v("id", m.id), v("pos", m.pos);
}
template <class V> void members(viz::poly &m, V &v) {
    v("name", m.name), v("role", m.role), v.rows("npt", m.npt, m.pt, 3), v("pt", m.pt);
}
template <class V> void members(viz::world &m, V &v) {
    v("run", m.run), v("version", m.version), v.rows("nseg", m.nseg, m.seg, 4), v("seg", m.seg);
    v.count("nanchor", m.nanchor, m.anchors), v("anchors", m.anchors);
    v.count("npoly", m.npoly, m.polys), v("polys", m.polys);
}
template <class V> void members(viz::range &m, V &v) {
    v("anchor", m.anchor), v("measured", m.measured), v("expected", m.expected), v("used", m.used);
}
template <class V> void members(viz::ranges &m, V &v) {
    v("t_us", m.t_us), v("run", m.run), v("object", m.object);
    v.count("n", m.n, m.items), v("items", m.items);
}
template <class V> void members(viz::fault &m, V &v) {
    v("object", m.object), v("probe", m.probe), v("type", m.type), v("params", m.params);
    v("from_us", m.from_us), v("to_us", m.to_us), v("active", m.active), v("hits", m.hits);
}
template <class V> void members(viz::faults &m, V &v) {
    v("t_us", m.t_us), v("run", m.run), v.count("n", m.n, m.items), v("items", m.items);
}
template <class V> void members(viz::event &m, V &v) {
    v("t_us", m.t_us), v("run", m.run), v("seq", m.seq), v("kind", m.kind);
    v("a", m.a), v("b", m.b), v("x", m.x), v("y", m.y), v("text", m.text);
}
template <class V> void members(viz::command &m, V &v) {
    v("t_us", m.t_us), v("index", m.index), v("name", m.name), v("args", m.args);
}
template <class V> void members(viz::case_info &m, V &v) {
    v("case_id", m.case_id), v("property", m.property), v("seed", m.seed);
    v("code_version", m.code_version), v("ncmd_original", m.ncmd_original);
    v.count("ncmd", m.ncmd, m.commands), v("commands", m.commands), v("params", m.params);
}
template <class V> void members(viz::status &m, V &v) {
    v("mode", m.mode), v("paused", m.paused), v("speed", m.speed), v("t_us", m.t_us);
    v("duration_us", m.duration_us), v("run", m.run), v("verdict", m.verdict);
    v("control_allowed", m.control_allowed), v("message", m.message);
}
template <class V> void members(viz::control &m, V &v) {
    v("client", m.client), v("token", m.token), v("seq", m.seq), v("verb", m.verb);
    v("object", m.object), v.count("nargs", m.nargs, m.args), v("args", m.args);
    v("text", m.text);
}
template <class V> void members(viz::ack &m, V &v) {
    v("client", m.client), v("seq", m.seq), v("ok", m.ok), v("text", m.text);
}

/* Calls f(channel, example) for each type that has a channel of its own. */
template <class F> void each_channel(F f) {
    f("VIZ_FRAME", viz::frame()), f("VIZ_RISK", viz::risk()), f("VIZ_WORLD", viz::world());
    f("VIZ_RANGE", viz::ranges()), f("VIZ_FAULTS", viz::faults()), f("VIZ_EVENT", viz::event());
    f("VIZ_CASE", viz::case_info()), f("VIZ_STATUS", viz::status());
    f("VIZ_CONTROL", viz::control()), f("VIZ_ACK", viz::ack());
}

} // namespace viz_test

#endif
