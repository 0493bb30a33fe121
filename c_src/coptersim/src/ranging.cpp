#include "ranging.h"

#include "kernels.h"

#include <algorithm>
#include <cmath>

namespace coptersim {

namespace {

constexpr double kConfidenceKept = 0.9; // from one sample to the next

// Middle of the latest errors, this one included.
double median_error(const RangeMemory &memory) {
    const std::size_t count = std::min<std::size_t>(memory.samples, RangeMemory::kRecent);
    double sorted[RangeMemory::kRecent];
    std::copy_n(memory.recent, count, sorted);
    std::sort(sorted, sorted + count);
    return sorted[(count - 1) / 2];
}

// More than half of the anchors disagree: the position is wrong, not the range.
bool most_disagree(const RangeMemory *memories, std::size_t count) {
    const auto misfits = std::count_if(memories, memories + count,
                                       [](const RangeMemory &memory) { return memory.misfit; });
    return 2 * static_cast<std::size_t>(misfits) > count;
}

bool passes_original(const Params &params, RangeMemory *memory) {
    if (!memory->misfit) {
        memory->misfits = 0;
        memory->out = false;
        return true;
    }
    ++memory->misfits;
    memory->out = memory->out || memory->misfits >= params.gate_count;
    return memory->out;
}

bool passes(const Params &params, double error, RangeMemory *memories, std::size_t count,
            std::size_t which) {
    RangeMemory &memory = memories[which];
    memory.misfit = std::fabs(error) > params.gate_error;
    memory.recent[memory.samples++ % RangeMemory::kRecent] = error;
    switch (static_cast<int>(params.gate)) {
    case kGateMedian:
        return std::fabs(error - median_error(memory)) <= params.gate_error;
    case kGateNeverAccept:
        return !memory.misfit;
    case kGateMajority:
        return !memory.misfit || most_disagree(memories, count);
    default:
        return passes_original(params, &memory);
    }
}

// The correction vector (m), its derivative (m/s), and the time since the last one (s).
struct Correction {
    double x, y, dx, dy, h;
};
struct Controller {
    double p, i, d, limit;
};
struct Output {
    double x, y;
};

// Proportional, integral and derivative parts; the integral ones are kept.
Output control(const Correction &c, const Controller &k, double *sum_x, double *sum_y) {
    *sum_x = std::clamp(*sum_x + c.x * k.i * c.h, -k.limit, k.limit);
    *sum_y = std::clamp(*sum_y + c.y * k.i * c.h, -k.limit, k.limit);
    return {c.x * k.p + *sum_x + c.dx * k.d, c.y * k.p + *sum_y + c.dy * k.d};
}

} // namespace

int Ranging::find(std::int32_t id) const {
    for (std::size_t i = 0; i < anchors_.size(); ++i)
        if (anchors_[i].id == id)
            return static_cast<int>(i);
    return -1;
}

void Ranging::add_anchor(const Anchor &anchor, std::size_t copters) {
    const int known = find(anchor.id);
    const std::size_t old_count = anchors_.size();
    const std::size_t count = known >= 0 ? old_count : old_count + 1;
    const std::size_t at = known >= 0 ? static_cast<std::size_t>(known) : old_count;
    std::vector<RangeMemory> memories(copters * count);
    for (std::size_t k = 0; k < copters; ++k)
        for (std::size_t a = 0; a < count; ++a)
            if (a != at)
                memories[k * count + a] = memories_[k * old_count + a];
    if (known >= 0)
        anchors_[at] = anchor;
    else
        anchors_.push_back(anchor);
    memories_.swap(memories);
}

void Ranging::clear_anchors() {
    anchors_.clear();
    memories_.clear();
    next_ = 0;
}

void Ranging::insert_copter(std::size_t at) {
    memories_.insert(memories_.begin() + static_cast<std::ptrdiff_t>(at * anchors_.size()),
                     anchors_.size(), RangeMemory());
}

void Ranging::erase_copter(std::size_t at) {
    const auto begin = memories_.begin() + static_cast<std::ptrdiff_t>(at * anchors_.size());
    memories_.erase(begin, begin + static_cast<std::ptrdiff_t>(anchors_.size()));
}

double distance_to(const Anchor &anchor, double x, double y, double z) {
    const double dx = x - anchor.x, dy = y - anchor.y, dz = z - anchor.z;
    return std::sqrt(dx * dx + dy * dy + dz * dz);
}

void correct(const Params &params, const RangeSample &sample, RangeMemory *memories,
             std::size_t count, std::size_t which, std::size_t i, Columns *copters) {
    StateColumns &belief = copters->belief;
    const csim_gains &gains = copters->gains[i];
    const double expected = distance_to(sample.anchor, belief.px[i], belief.py[i], sample.altitude);
    double error = expected - sample.measured;
    RangeMemory &memory = memories[which];
    memory.measured_at = sample.now;
    memory.measured = sample.measured;
    memory.expected = expected;
    memory.used = false;
    if (expected == 0 || !std::isfinite(error))
        return;
    const double size = std::min(std::fabs(error), gains.max_corr);
    copters->confidence[i] = std::max(size, kConfidenceKept * copters->confidence[i]);
    if (!passes(params, error, memories, count, which)) {
        ++copters->rejected[i];
        return;
    }
    memory.used = true;
    error = std::clamp(error, -gains.max_corr, gains.max_corr);
    const double cx = (belief.px[i] - sample.anchor.x) * error / expected;
    const double cy = (belief.py[i] - sample.anchor.y) * error / expected;
    const double h =
        memory.accepted ? static_cast<double>(sample.now - memory.accepted_at) * 1e-6 : 0;
    const double dx = h > 0 ? (cx - memory.last_x) / h : 0;
    const double dy = h > 0 ? (cy - memory.last_y) / h : 0;
    memory.accepted = true;
    memory.accepted_at = sample.now;
    memory.last_x = cx;
    memory.last_y = cy;
    const Correction c{cx, cy, dx, dy, h};
    const Output pos = control(c, {gains.pos_p, gains.pos_i, gains.pos_d, params.limit_pos},
                               &memory.pos_x, &memory.pos_y);
    const Output vel = control(c, {gains.vel_p, gains.vel_i, gains.vel_d, params.limit_vel},
                               &memory.vel_x, &memory.vel_y);
    const Output acc = control(c, {gains.acc_p, gains.acc_i, gains.acc_d, params.limit_acc},
                               &memory.acc_x, &memory.acc_y);
    belief.px[i] -= pos.x;
    belief.py[i] -= pos.y;
    belief.vx[i] -= vel.x;
    belief.vy[i] -= vel.y;
    const csim_kernels::direction<double> heading = csim_kernels::sin_cos(belief.yaw[i]);
    belief.e_r[i] = std::clamp(belief.e_r[i] - (acc.x * heading.cosine + acc.y * heading.sine),
                               -gains.max_tilt, gains.max_tilt);
    belief.e_p[i] = std::clamp(belief.e_p[i] + (acc.y * heading.cosine - acc.x * heading.sine),
                               -gains.max_tilt, gains.max_tilt);
}

} // namespace coptersim
