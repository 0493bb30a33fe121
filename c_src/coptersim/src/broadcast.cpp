#include "broadcast.h"

#include <algorithm>
#include <cstring>

namespace coptersim {

namespace {

template <class Rows> auto lower_row(Rows &rows, std::int32_t id) {
    return std::lower_bound(rows.begin(), rows.end(), id,
                            [](const auto &row, std::int32_t key) { return row.id < key; });
}

auto lower_map(std::vector<PrivateMap> &maps, std::int32_t receiver) {
    return std::lower_bound(
        maps.begin(), maps.end(), receiver,
        [](const PrivateMap &map, std::int32_t key) { return map.receiver < key; });
}

void expire_rows(std::vector<TableRow> &rows, std::uint64_t now, std::uint64_t expiry, bool low,
                 bool high) {
    for (TableRow &row : rows) {
        const bool expired = row.valid && has_expired(row.heard.stamp, now, expiry);
        row.gone_low = row.gone_low || (low && expired);
        row.gone_high = row.gone_high || (high && expired);
    }
}

bool same_heard(const Heard &a, const Heard &b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

} // namespace

PrivateRow *PrivateMap::find(std::int32_t id) {
    const auto at = lower_row(rows, id);
    return at != rows.end() && at->id == id ? &*at : nullptr;
}

PrivateRow &PrivateMap::row(std::int32_t id) {
    const auto at = lower_row(rows, id);
    if (at != rows.end() && at->id == id)
        return *at;
    return *rows.insert(at, PrivateRow{id, {}, 0, 0, {}});
}

void PrivateMap::expire(std::uint64_t now_us, std::uint64_t expiry) {
    rows.erase(std::remove_if(rows.begin(), rows.end(),
                              [=](const PrivateRow &row) {
                                  return has_expired(row.heard.stamp, now_us, expiry);
                              }),
               rows.end());
}

// Keeps the rows of senders that are gone but not forgotten.
void Broadcasts::set_senders(const std::vector<std::int32_t> &ids) {
    std::vector<TableRow> rows;
    rows.reserve(now.size() + ids.size());
    auto old = now.begin();
    const auto keep_until = [&](auto end) {
        for (; old != end; ++old)
            if (old->valid && !(old->gone_low && old->gone_high))
                rows.push_back(*old);
    };
    row_of_.clear();
    for (const std::int32_t id : ids) {
        keep_until(std::lower_bound(
            old, now.end(), id, [](const TableRow &r, std::int32_t key) { return r.id < key; }));
        const bool known = old != now.end() && old->id == id;
        rows.push_back(known ? *old : TableRow());
        rows.back().id = id;
        row_of_.push_back(rows.size() - 1);
        if (known)
            ++old;
    }
    keep_until(now.end());
    now.swap(rows);
    before = now;
}

void Broadcasts::clear() {
    now.clear();
    before.clear();
    row_of_.clear();
    privates.clear();
    count = 0;
    last_at = 0;
    quiet_until_ = 0;
}

void Broadcasts::start_broadcast() {
    before = now;
    ++count;
}

// While no stamp can be too old or from the future nothing is to be done.
void Broadcasts::expire(std::uint64_t now_us, std::uint64_t expiry, bool broadcast) {
    if (broadcast) {
        expire_rows(before, now_us, expiry, true, false);
        expire_rows(now, now_us, expiry, false, true);
        note_stamps(now_us, expiry);
    } else if (now_us > quiet_until_) {
        expire_rows(now, now_us, expiry, true, true);
        note_stamps(now_us, expiry);
    }
}

void Broadcasts::note_stamps(std::uint64_t now_us, std::uint64_t expiry) {
    std::uint64_t oldest = UINT64_MAX;
    for (const TableRow &row : now) {
        if (!row.valid || (row.gone_low && row.gone_high))
            continue;
        if (row.heard.stamp > now_us)
            oldest = 0;
        oldest = std::min(oldest, row.heard.stamp);
    }
    quiet_until_ = oldest > UINT64_MAX - expiry ? UINT64_MAX : oldest == 0 ? 0 : oldest + expiry;
}

PrivateMap *Broadcasts::find_private(std::int32_t receiver) {
    const auto at = lower_map(privates, receiver);
    return at != privates.end() && at->receiver == receiver ? &*at : nullptr;
}

const PrivateMap *Broadcasts::find_private(std::int32_t receiver) const {
    return const_cast<Broadcasts *>(this)->find_private(receiver);
}

// It starts with what the receiver knows of the shared table.
PrivateMap &Broadcasts::make_private(std::int32_t receiver, std::uint64_t born,
                                     std::string channel) {
    const auto at = lower_map(privates, receiver);
    if (at != privates.end() && at->receiver == receiver)
        return *at;
    PrivateMap &map =
        *privates.insert(at, PrivateMap{receiver, std::move(channel), false, last_at, {}});
    for (const TableRow &row : now)
        if (knows(row, receiver, born)) {
            const LinkState link{static_cast<std::uint16_t>(row.number), true};
            map.rows.push_back({row.id, row.heard, known_from(row, receiver), row.at, link});
        }
    return map;
}

void Broadcasts::end_private(std::int32_t receiver) {
    const auto at = lower_map(privates, receiver);
    if (at != privates.end() && at->receiver == receiver)
        privates.erase(at);
}

bool Broadcasts::agrees_with_table(const PrivateMap &map, std::uint64_t born) const {
    auto row = map.rows.begin();
    for (const TableRow &shared : now) {
        if (!knows(shared, map.receiver, born))
            continue;
        if (row == map.rows.end() || row->id != shared.id ||
            row->from != known_from(shared, map.receiver) || !same_heard(row->heard, shared.heard))
            return false;
        ++row;
    }
    return row == map.rows.end();
}

} // namespace coptersim
