// Who has heard what: a table of the latest broadcasts that all receivers share, and rows of their
// own for receivers whose channel is or was faulted.
#pragma once

#include "message.h"
#include "protection.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace coptersim {

// A copter's latest broadcast. Receivers with a larger id heard it in the step it was made in,
// before they looked around; those with a smaller id just after. `gone` tells for either that it
// has expired.
struct TableRow {
    std::int32_t id = 0;
    bool valid = false;                       // it has made a broadcast
    bool gone_low = false, gone_high = false; // for receivers with a smaller, a larger id
    Heard heard{};
    std::uint64_t at = 0;     // us, end of the step it was made in
    std::uint64_t lasted = 0; // us, length of that step
    std::uint64_t number = 0; // of the broadcast, from 1
};

// An entry of a receiver with rows of its own.
struct PrivateRow {
    std::int32_t id;
    Heard heard;
    std::uint64_t from; // us: the position was heard.px, heard.py at this time
    std::uint64_t at;   // us, end of the step in which it was heard
    LinkState link;
};

struct PrivateMap {
    std::int32_t receiver;
    std::string channel;
    bool armed;                   // the channel has faults, or is watched
    std::uint64_t heard_at;       // us, when it last accepted a message of anybody
    std::vector<PrivateRow> rows; // in ascending id
    PrivateRow *find(std::int32_t id);
    PrivateRow &row(std::int32_t id); // made when missing
    void expire(std::uint64_t now_us, std::uint64_t expiry);
};

class Broadcasts {
  public:
    std::uint64_t count = 0;   // made so far
    std::uint64_t last_at = 0; // us, of the latest one that somebody could hear

    // Rows in ascending id; `before` holds what was known before the broadcast of this step, and is
    // of use only in a step with one. Both have the same ids.
    std::vector<TableRow> now, before;

    // Row of the i-th copter.
    std::size_t row_of(std::size_t copter) const {
        return row_of_[copter];
    }
    // After copters were added or removed.
    void set_senders(const std::vector<std::int32_t> &ids);
    void clear();
    void start_broadcast();
    // Updates the gone flags at a time; in a step with a broadcast for both tables.
    void expire(std::uint64_t now_us, std::uint64_t expiry, bool broadcast);

    // ---- receivers with rows of their own ----
    std::vector<PrivateMap> privates; // in ascending receiver
    PrivateMap *find_private(std::int32_t receiver);
    const PrivateMap *find_private(std::int32_t receiver) const;
    PrivateMap &make_private(std::int32_t receiver, std::uint64_t born, std::string channel);
    void end_private(std::int32_t receiver);
    // True when the rows say what the shared table says.
    bool agrees_with_table(const PrivateMap &map, std::uint64_t born) const;

  private:
    // When rows may next have to be looked at.
    void note_stamps(std::uint64_t now_us, std::uint64_t expiry);

    std::vector<std::size_t> row_of_;
    std::uint64_t quiet_until_ = 0;
};

// Does a receiver know of a row? own rows aside.
inline bool knows(const TableRow &row, std::int32_t receiver, std::uint64_t born) {
    return row.valid && row.number > born && row.id != receiver &&
           !(row.id > receiver ? row.gone_low : row.gone_high);
}

// Since when a receiver has moved the entry on.
inline std::uint64_t known_from(const TableRow &row, std::int32_t receiver) {
    return row.at - (row.id < receiver ? row.lasted : 0);
}

} // namespace coptersim
