#include "terrain.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coptersim {

namespace {

constexpr std::uint32_t kLeaf = 4; // lines

} // namespace

Line make_line(std::int32_t id, double x1, double y1, double x2, double y2) {
    Line line{id, x1, y1, x2, y2, x1 + 0.5 * (x2 - x1), y1 + 0.5 * (y2 - y1), 0, 1, 0};
    const double dx = x2 - x1, dy = y2 - y1;
    line.length = std::sqrt(dx * dx + dy * dy);
    if (line.length > 0) {
        line.along_x = dx / line.length;
        line.along_y = dy / line.length;
    }
    return line;
}

Place closest_point(const Line &line, double x, double y) {
    double t = (x - line.x1) * line.along_x + (y - line.y1) * line.along_y;
    if (t <= 0)
        return {line.x1, line.y1};
    if (t >= line.length)
        return {line.x2, line.y2};
    return {line.x1 + t * line.along_x, line.y1 + t * line.along_y};
}

int Terrain::find(std::int32_t id) const {
    const auto at =
        std::lower_bound(lines_.begin(), lines_.end(), id,
                         [](const Line &line, std::int32_t key) { return line.id < key; });
    return at != lines_.end() && at->id == id ? static_cast<int>(at - lines_.begin()) : -1;
}

void Terrain::add(const Line &line) {
    const auto at = std::lower_bound(lines_.begin(), lines_.end(), line.id,
                                     [](const Line &a, std::int32_t key) { return a.id < key; });
    if (at != lines_.end() && at->id == line.id)
        *at = line;
    else
        lines_.insert(at, line);
    stale_ = true;
}

void Terrain::clear() {
    lines_.clear();
    stale_ = true;
}

// The box around a rectangle that holds the line and the ellipse at rest.
void Terrain::prepare(double base, double length_divisor) {
    if (!stale_ && base == base_ && length_divisor == length_divisor_)
        return;
    stale_ = false;
    base_ = base;
    length_divisor_ = length_divisor;
    boxes_.clear();
    for (const Line &line : lines_) {
        const double along = std::max(base + line.length / length_divisor, 0.5 * line.length);
        const double dx = std::fabs(line.along_x) * along + std::fabs(line.along_y) * base;
        const double dy = std::fabs(line.along_y) * along + std::fabs(line.along_x) * base;
        boxes_.push_back({line.mid_x - dx, line.mid_y - dy, line.mid_x + dx, line.mid_y + dy});
    }
    order_.resize(lines_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.clear();
    if (!lines_.empty())
        build_node(0, static_cast<std::uint32_t>(order_.size()));
}

// Halves at the median of the longer side. Returns the node's place.
std::uint32_t Terrain::build_node(std::uint32_t begin, std::uint32_t end) {
    const auto place = static_cast<std::uint32_t>(nodes_.size());
    Box all = boxes_[order_[begin]];
    for (std::uint32_t i = begin; i < end; ++i) {
        const Box &box = boxes_[order_[i]];
        all = {std::min(all.x1, box.x1), std::min(all.y1, box.y1), std::max(all.x2, box.x2),
               std::max(all.y2, box.y2)};
    }
    nodes_.push_back({all, begin, end, 0});
    if (end - begin <= kLeaf)
        return place;
    const bool wide = all.x2 - all.x1 > all.y2 - all.y1;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const Line &p = lines_[a], &q = lines_[b];
                         return wide ? p.mid_x < q.mid_x : p.mid_y < q.mid_y;
                     });
    build_node(begin, middle);
    nodes_[place].right = build_node(middle, end);
    return place;
}

} // namespace coptersim
