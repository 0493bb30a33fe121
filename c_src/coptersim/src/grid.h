// Finds the points near a place: cells of a plane without limits, hashed.
//
// What near() visits is a superset of the points within the radius; the caller measures.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace coptersim {

// Beyond this, in metres, doubles are too coarse for the slack below: such points stay outside.
constexpr double kGridLimit = 1e8;

inline bool fits_grid(double x, double y) {
    return std::fabs(x) < kGridLimit && std::fabs(y) < kGridLimit;
}

class HashGrid {
  public:
    // Room for that many points: build then allocates nothing.
    void reserve(std::size_t count);

    void clear(double cell) {
        points_.clear();
        inverse_ = 1 / cell;
    }
    // The point must fit the grid.
    void add(double x, double y, std::uint32_t item) {
        points_.push_back({cell_of(x), cell_of(y), item});
    }
    void build();

    std::size_t size() const {
        return points_.size();
    }

    template <class Visit> void near(double x, double y, double radius, Visit visit) const {
        if (points_.empty())
            return;
        const double reach = radius * (1 + 1e-9) + 1e-6;
        const double low_x = (x - reach) * inverse_, high_x = (x + reach) * inverse_;
        const double low_y = (y - reach) * inverse_, high_y = (y + reach) * inverse_;
        const double cells = (high_x - low_x + 2) * (high_y - low_y + 2);
        if (!fits_grid(x, y) || !(cells < 2.0 * static_cast<double>(points_.size()) + 16)) {
            for (const Point &point : points_)
                visit(point.item);
            return;
        }
        const std::int64_t x1 = cell_of(x + reach), y1 = cell_of(y + reach),
                           y0 = cell_of(y - reach);
        for (std::int64_t cx = cell_of(x - reach); cx <= x1; ++cx)
            for (std::int64_t cy = y0; cy <= y1; ++cy)
                visit_cell(cx, cy, visit);
    }

  private:
    struct Point {
        std::int64_t cx, cy;
        std::uint32_t item;
    };

    std::int64_t cell_of(double value) const {
        return static_cast<std::int64_t>(std::floor(value * inverse_));
    }
    std::size_t bucket_of(std::int64_t cx, std::int64_t cy) const {
        std::uint64_t hash = static_cast<std::uint64_t>(cx) * 0x9e3779b97f4a7c15u;
        hash = (hash ^ static_cast<std::uint64_t>(cy)) * 0xc2b2ae3d27d4eb4fu;
        return static_cast<std::size_t>(hash >> 32) & mask_;
    }
    template <class Visit> void visit_cell(std::int64_t cx, std::int64_t cy, Visit &visit) const {
        const std::size_t bucket = bucket_of(cx, cy);
        for (std::uint32_t at = start_[bucket]; at < start_[bucket + 1]; ++at) {
            const Point &point = sorted_[at];
            if (point.cx == cx && point.cy == cy)
                visit(point.item);
        }
    }

    double inverse_ = 1;
    std::size_t mask_ = 0;
    std::vector<Point> points_, sorted_;
    std::vector<std::uint32_t> start_;
};

} // namespace coptersim
