#include "collision.h"

#include <algorithm>
#include <tuple>

namespace coptersim {

namespace {

// Smaller id, terrain first, other id.
auto key_of(const csim_collision &c) {
    return std::make_tuple(c.id, static_cast<int>(c.kind), c.other);
}
bool is_before(const csim_collision &a, const csim_collision &b) {
    return key_of(a) < key_of(b);
}

} // namespace

void Collisions::forget_copter(std::int32_t id) {
    touching_.erase(std::remove_if(touching_.begin(), touching_.end(),
                                   [id](const csim_collision &c) {
                                       return c.id == id ||
                                              (c.kind == CSIM_COPTER && c.other == id);
                                   }),
                    touching_.end());
}

void Collisions::forget_line(std::int32_t id) {
    touching_.erase(std::remove_if(touching_.begin(), touching_.end(),
                                   [id](const csim_collision &c) {
                                       return c.kind == CSIM_TERRAIN && c.other == id;
                                   }),
                    touching_.end());
}

void Collisions::reserve(std::size_t copters) {
    recorded_.reserve(copters + 16);
    found_.reserve(4 * copters + 16);
    touching_.reserve(4 * copters + 16);
}

void Collisions::find_pairs(const Params &params, const Columns &copters, const ContactTable *table,
                            std::uint64_t now) {
    const StateColumns &truth = copters.truth;
    const double limit = 4 * params.copter_radius * params.copter_radius;
    const auto test = [&](std::size_t i, std::size_t j) {
        const double dx = truth.px[j] - truth.px[i], dy = truth.py[j] - truth.py[i];
        if (dx * dx + dy * dy < limit)
            found_.push_back({CSIM_COPTER, copters.id[std::min(i, j)], copters.id[std::max(i, j)],
                              now, truth.px[i] + 0.5 * dx, truth.py[i] + 0.5 * dy});
    };
    const std::size_t count = copters.size();
    const auto is_loose = [&](std::size_t i) { return table != nullptr && table->is_loose(i); };
    for (std::size_t i = 0; i < count; ++i) {
        if (is_loose(i)) {
            for (std::size_t j = 0; j < count; ++j)
                if (j > i || (j < i && !is_loose(j)))
                    test(std::min(i, j), std::max(i, j));
        } else if (table == nullptr || table->copters.is_all(i)) {
            for (std::size_t j = i + 1; j < count; ++j)
                if (!is_loose(j))
                    test(i, j);
        } else {
            for (const std::uint32_t *j = table->copters.begin(i); j != table->copters.end(i); ++j)
                if (!is_loose(*j))
                    test(i, *j);
        }
    }
}

void Collisions::find_lines(const Params &params, const Terrain &terrain, const Columns &copters,
                            const ContactTable *table, std::uint64_t now) {
    const std::vector<Line> &lines = terrain.lines();
    const double limit = params.copter_radius * params.copter_radius;
    const auto test = [&](std::size_t i, const Line &line) {
        const double x = copters.truth.px[i], y = copters.truth.py[i];
        const Place near = closest_point(line, x, y);
        const double dx = near.x - x, dy = near.y - y;
        if (dx * dx + dy * dy < limit)
            found_.push_back({CSIM_TERRAIN, copters.id[i], line.id, now, near.x, near.y});
    };
    for (std::size_t i = 0; i < copters.size(); ++i) {
        if (table == nullptr || table->lines.is_all(i)) {
            for (const Line &line : lines)
                test(i, line);
        } else {
            for (const std::uint32_t *at = table->lines.begin(i); at != table->lines.end(i); ++at)
                test(i, lines[*at]);
        }
    }
}

bool Collisions::check(const Params &params, const Terrain &terrain, const Columns &copters,
                       const ContactTable *table, std::uint64_t now) {
    found_.clear();
    find_pairs(params, copters, table, now);
    find_lines(params, terrain, copters, table, now);
    std::sort(found_.begin(), found_.end(), is_before);
    bool any = false;
    for (const csim_collision &contact : found_)
        if (!std::binary_search(touching_.begin(), touching_.end(), contact, is_before)) {
            recorded_.push_back(contact);
            any = true;
        }
    touching_.swap(found_);
    return any;
}

} // namespace coptersim
