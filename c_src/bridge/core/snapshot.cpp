#include "snapshot.hpp"

#include <algorithm>

namespace cb {

namespace {

// Not memcpy: AddressSanitizer would see it run over the gaps between variables.
inline void copy_bytes(unsigned char *to, const unsigned char *from, std::size_t count) {
#if defined(__x86_64__)
    asm volatile("rep movsb" : "+D"(to), "+S"(from), "+c"(count) : : "memory");
#else
    for (volatile unsigned char *out = to; count > 0; --count) {
        *out++ = *from++;
    }
#endif
}

} // namespace

void Snapshot::take(const std::vector<Range> &ranges, std::vector<Range> excluded) {
    clear();
    std::sort(excluded.begin(), excluded.end(),
              [](const Range &a, const Range &b) { return a.start < b.start; });
    for (const Range &range : ranges) {
        unsigned char *from = range.start;
        unsigned char *const end = range.start + range.size;
        for (const Range &gap : excluded) {
            if (gap.start >= end || gap.start + gap.size <= from) {
                continue;
            }
            if (gap.start > from) {
                ranges_.push_back(Range{from, static_cast<std::size_t>(gap.start - from)});
            }
            from = std::min(end, gap.start + gap.size);
        }
        if (from < end) {
            ranges_.push_back(Range{from, static_cast<std::size_t>(end - from)});
        }
    }
    std::size_t total = 0;
    for (const Range &range : ranges_) {
        total += range.size;
    }
    saved_.resize(total);
    unsigned char *to = saved_.data();
    for (const Range &range : ranges_) {
        copy_bytes(to, range.start, range.size);
        to += range.size;
    }
}

bool Snapshot::restore() const {
    const unsigned char *from = saved_.data();
    for (const Range &range : ranges_) {
        copy_bytes(range.start, from, range.size);
        from += range.size;
    }
    return !ranges_.empty();
}

void Snapshot::clear() {
    ranges_.clear();
    saved_.clear();
}

} // namespace cb
