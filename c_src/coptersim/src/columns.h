// The copters' states as structure of arrays, in ascending order of id.
//
// Every column is aligned to, and padded with zeros to a multiple of, the widest vector, so that a
// loop over a column never has a tail.
#pragma once

#include "csim.h"

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

namespace coptersim {

constexpr std::size_t kLanes = 8; // doubles in the widest vector
constexpr std::size_t kColumnAlignment = kLanes * sizeof(double);

template <class T> struct ColumnAllocator {
    using value_type = T;
    ColumnAllocator() = default;
    template <class U> ColumnAllocator(const ColumnAllocator<U> &) {}
    T *allocate(std::size_t n) {
        return static_cast<T *>(::operator new (n * sizeof(T), std::align_val_t{kColumnAlignment}));
    }
    void deallocate(T *p, std::size_t) {
        ::operator delete (p, std::align_val_t{kColumnAlignment});
    }
    bool operator==(const ColumnAllocator &) const {
        return true;
    }
    bool operator!=(const ColumnAllocator &) const {
        return false;
    }
};

using Column = std::vector<double, ColumnAllocator<double>>;

inline std::size_t padded(std::size_t count) {
    return (count + kLanes - 1) / kLanes * kLanes;
}

// Members as csim_state.
struct StateColumns {
    Column px, py, pz, vx, vy, roll, pitch, yaw, e_r, e_p;

    template <class F> void each(F f) {
        for (Column *column : {&px, &py, &pz, &vx, &vy, &roll, &pitch, &yaw, &e_r, &e_p})
            f(*column);
    }
    csim_state at(std::size_t i) const {
        return {px[i], py[i], pz[i], vx[i], vy[i], roll[i], pitch[i], yaw[i], e_r[i], e_p[i]};
    }
    void set(std::size_t i, const csim_state &state);
};

struct Columns {
    std::vector<std::int32_t> id;
    StateColumns truth, belief;
    Column pilot_roll, pilot_pitch, pilot_yaw, throttle; // commands, -1..1
    Column roll, pitch, yaw;                             // what is followed: pilot or override
    Column max_error2;                                   // m^2
    Column confidence;                                   // m, recent size of range errors
    std::vector<std::uint8_t> override_active;
    std::vector<std::uint64_t> override_steps, rejected;
    std::vector<std::uint64_t> born; // broadcasts made before it was added
    // Attitude or tilt estimate may differ between truth and belief, so that each needs its own
    // trigonometry.
    std::vector<std::uint8_t> own_attitude;
    std::vector<csim_gains> gains;

    std::size_t size() const {
        return id.size();
    }
    // Index of a copter, or -1.
    std::ptrdiff_t find(std::int32_t copter) const;
    // Where a copter of that id is, or would be.
    std::size_t lower(std::int32_t copter) const;
    void insert(std::size_t at, std::int32_t copter);
    void erase(std::size_t at);

  private:
    template <class F> void each_column(F f);
};

} // namespace coptersim
