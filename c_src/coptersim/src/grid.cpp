#include "grid.h"

namespace coptersim {

namespace {

std::size_t buckets_for(std::size_t count) {
    std::size_t buckets = 16;
    while (buckets < 2 * count)
        buckets *= 2;
    return buckets;
}

} // namespace

void HashGrid::reserve(std::size_t count) {
    points_.reserve(count);
    sorted_.reserve(count);
    start_.reserve(buckets_for(count) + 1);
}

// Counting sort by bucket.
void HashGrid::build() {
    const std::size_t buckets = buckets_for(points_.size());
    mask_ = buckets - 1;
    start_.assign(buckets + 1, 0);
    sorted_.resize(points_.size());
    for (const Point &point : points_)
        ++start_[bucket_of(point.cx, point.cy)];
    std::uint32_t end = 0;
    for (std::uint32_t &start : start_)
        start = end += start;
    for (std::size_t i = points_.size(); i-- > 0;)
        sorted_[--start_[bucket_of(points_[i].cx, points_[i].cy)]] = points_[i];
}

} // namespace coptersim
