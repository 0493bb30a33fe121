#include "columns.h"

#include <algorithm>

namespace coptersim {

namespace {

void insert_into(Column &column, std::size_t at, std::size_t count) {
    column.insert(column.begin() + static_cast<std::ptrdiff_t>(at), 0.0);
    column.resize(padded(count + 1), 0.0);
}

void erase_from(Column &column, std::size_t at, std::size_t count) {
    column.erase(column.begin() + static_cast<std::ptrdiff_t>(at));
    column.resize(padded(count - 1), 0.0);
}

template <class T> void insert_into(std::vector<T> &rows, std::size_t at) {
    rows.insert(rows.begin() + static_cast<std::ptrdiff_t>(at), T());
}

template <class T> void erase_from(std::vector<T> &rows, std::size_t at) {
    rows.erase(rows.begin() + static_cast<std::ptrdiff_t>(at));
}

} // namespace

void StateColumns::set(std::size_t i, const csim_state &state) {
    px[i] = state.px;
    py[i] = state.py;
    pz[i] = state.pz;
    vx[i] = state.vx;
    vy[i] = state.vy;
    roll[i] = state.roll;
    pitch[i] = state.pitch;
    yaw[i] = state.yaw;
    e_r[i] = state.e_r;
    e_p[i] = state.e_p;
}

std::size_t Columns::lower(std::int32_t copter) const {
    if (id.empty() || copter > id.back())
        return id.size();
    return static_cast<std::size_t>(std::lower_bound(id.begin(), id.end(), copter) - id.begin());
}

std::ptrdiff_t Columns::find(std::int32_t copter) const {
    const std::size_t at = lower(copter);
    return at < id.size() && id[at] == copter ? static_cast<std::ptrdiff_t>(at) : -1;
}

template <class F> void Columns::each_column(F f) {
    truth.each(f);
    belief.each(f);
    for (Column *column : {&pilot_roll, &pilot_pitch, &pilot_yaw, &throttle, &roll, &pitch, &yaw,
                           &max_error2, &confidence})
        f(*column);
}

void Columns::insert(std::size_t at, std::int32_t copter) {
    const std::size_t count = id.size();
    each_column([&](Column &column) { insert_into(column, at, count); });
    insert_into(override_active, at);
    insert_into(override_steps, at);
    insert_into(rejected, at);
    insert_into(born, at);
    insert_into(own_attitude, at);
    insert_into(gains, at);
    insert_into(id, at);
    id[at] = copter;
}

void Columns::erase(std::size_t at) {
    const std::size_t count = id.size();
    each_column([&](Column &column) { erase_from(column, at, count); });
    erase_from(override_active, at);
    erase_from(override_steps, at);
    erase_from(rejected, at);
    erase_from(born, at);
    erase_from(own_attitude, at);
    erase_from(gains, at);
    erase_from(id, at);
}

} // namespace coptersim
