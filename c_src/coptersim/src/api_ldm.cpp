// csim_ldm: what a copter knows of others, with risk contours.
#include "api.h"
#include "kernels.h"
#include "risk.h"
#include "step.h"

#include <algorithm>
#include <vector>

using namespace coptersim;

namespace {

csim_ldm_entry entry_of(csim_entry_kind kind, std::int32_t id, const Ellipse &ellipse,
                        const Own &own) {
    csim_ldm_entry entry{};
    entry.kind = kind;
    entry.id = id;
    entry.cx = ellipse.cx;
    entry.cy = ellipse.cy;
    entry.along = ellipse.along;
    entry.across = ellipse.across;
    entry.angle = csim_kernels::atan2(ellipse.ey, ellipse.ex);
    entry.overlap = overlap_of(ellipse, own) < 1;
    return entry;
}

csim_ldm_entry comfort_entry(std::int32_t id, const Own &own) {
    csim_ldm_entry entry{};
    entry.kind = CSIM_ENTRY_COMFORT;
    entry.id = id;
    entry.x = entry.cx = own.x;
    entry.y = entry.cy = own.y;
    entry.vx = own.vx;
    entry.vy = own.vy;
    entry.along = entry.across = own.comfort;
    return entry;
}

csim_ldm_entry copter_entry(const Params &params, const Own &own, std::int32_t id,
                            const Heard &heard, std::uint64_t from, std::uint64_t now) {
    const Position place = extrapolate(heard, from, now);
    const Other other{place.x, place.y, heard.vx, heard.vy, age_of(heard.stamp, now)};
    csim_ldm_entry entry = entry_of(CSIM_ENTRY_COPTER, id, copter_ellipse(params, own, other), own);
    entry.stamp_us = heard.stamp;
    entry.x = place.x;
    entry.y = place.y;
    entry.vx = heard.vx;
    entry.vy = heard.vy;
    return entry;
}

std::vector<csim_ldm_entry> entries_of(const csim &sim, std::size_t i) {
    const World &world = sim.world;
    const Params &params = world.params;
    const std::int32_t id = world.copters.id[i];
    const Own own = own_of(world, i);
    const std::uint64_t now = world.time_us;
    std::vector<csim_ldm_entry> entries{comfort_entry(id, own)};
    if (const PrivateMap *map = world.broadcasts.find_private(id)) {
        for (const PrivateRow &row : map->rows)
            if (!has_expired(row.heard.stamp, now, params.expiry()))
                entries.push_back(copter_entry(params, own, row.id, row.heard, row.from, now));
    } else {
        for (const TableRow &row : world.broadcasts.now)
            if (knows(row, id, world.copters.born[i]))
                entries.push_back(
                    copter_entry(params, own, row.id, row.heard, known_from(row, id), now));
    }
    for (const Line &line : world.terrain.lines()) {
        csim_ldm_entry entry =
            entry_of(CSIM_ENTRY_LINE, line.id, line_ellipse(params, own, line), own);
        entry.x = line.mid_x;
        entry.y = line.mid_y;
        entries.push_back(entry);
    }
    return entries;
}

} // namespace

extern "C" int csim_ldm(const csim *sim, int32_t copter, csim_ldm_entry *entries, size_t *count) {
    std::size_t i = 0;
    if (const int code = find_copter(sim, copter, "csim_ldm", &i))
        return code;
    if (count == nullptr)
        return fail_null("csim_ldm", "count");
    return guarded("csim_ldm",
                   [&] { return copy_out(entries_of(*sim, i), entries, count, "csim_ldm"); });
}
