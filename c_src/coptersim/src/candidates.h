// Whom a copter need not look at: short lists of what may come close, good until it has moved.
//
// A list holds everything that can matter while the copter stays within `margin` of where it was
// and below `speed`; the tables behind the lists are good until a time. What lists leave out would
// have changed nothing, so results are those of looking at everything.
#pragma once

#include "broadcast.h"
#include "columns.h"
#include "grid.h"
#include "params.h"
#include "terrain.h"

#include <array>
#include <cstdint>
#include <vector>

namespace coptersim {

// Lists of fixed room, one for each copter.
class Lists {
  public:
    static constexpr std::uint16_t kAll = UINT16_MAX; // did not fit: look at everything

    void resize(std::size_t copters, std::size_t room) {
        room_ = room;
        count_.assign(copters, 0);
        items_.assign(copters * room, 0);
    }
    void start(std::size_t copter) {
        count_[copter] = 0;
    }
    void add(std::size_t copter, std::uint32_t item) {
        std::uint16_t &count = count_[copter];
        if (count == kAll)
            return;
        if (count == room_)
            count = kAll;
        else
            items_[copter * room_ + count++] = item;
    }
    void set_all(std::size_t copter) {
        count_[copter] = kAll;
    }
    void sort(std::size_t copter);
    bool is_all(std::size_t copter) const {
        return count_[copter] == kAll;
    }
    bool empty(std::size_t copter) const {
        return count_[copter] == 0;
    }
    const std::uint32_t *begin(std::size_t copter) const {
        return items_.data() + copter * room_;
    }
    const std::uint32_t *end(std::size_t copter) const {
        return begin(copter) + count_[copter];
    }

  private:
    std::size_t room_ = 0;
    std::vector<std::uint16_t> count_;
    std::vector<std::uint32_t> items_;
};

// Where a copter was when its lists were made, and how long they hold.
struct Held {
    double x = 0, y = 0;
    double margin2 = -1; // m^2; negative: there are no lists
    double speed2 = 0;   // m^2/s^2

    bool holds(double px, double py, double vx, double vy) const {
        const double dx = px - x, dy = py - y;
        return dx * dx + dy * dy <= margin2 && vx * vx + vy * vy <= speed2;
    }
};

// The broadcasts known at a time, in grids by speed: a fast sender reaches far.
class RiskTable {
  public:
    void resize(std::size_t copters, std::size_t rows, std::size_t lines);
    void drop_lists();
    // Grids over the table; lists made from them hold until `until` (us).
    void build(const Params &params, const std::vector<TableRow> &rows, std::uint64_t now,
               std::uint64_t until);
    bool covers(std::uint64_t now) const {
        return built_ && now <= until_;
    }
    // Threads may make the lists of different copters at a time.
    void make_lists(const Params &params, const Terrain &terrain, const Columns &copters,
                    std::size_t copter);

    std::vector<Held> held;
    Lists rows, lines;

  private:
    static constexpr int kClasses = 6; // speeds up to 1, 2, 4 ... 32 m/s; faster ones are loose
    static int class_of(double speed);

    bool built_ = false;
    std::uint64_t until_ = 0;
    double horizon_ = 0;      // s, that a list must hold
    double longest_step_ = 0; // s, of the steps in which the rows were sent
    std::array<HashGrid, kClasses> grids_;
    std::vector<std::uint32_t> loose_;  // rows that no grid holds
    std::vector<double> x_, y_, speed_; // of the rows
};

// True positions: who may touch whom, or which line.
class ContactTable {
  public:
    void resize(std::size_t copters);
    void drop_lists() {
        built_ = false;
    }
    // Makes lists anew where copters have left their margins.
    void refresh(const Params &params, const Terrain &terrain, const Columns &copters);

    Lists copters, lines; // a pair is in the list of one of both, or one of both has all

    // A copter that must be tested against all others.
    bool is_loose(std::size_t copter) const {
        return loose_[copter] != 0;
    }

  private:
    void build(const Params &params, const Terrain &terrain, const Columns &copters);
    void make_lists(const Params &params, const Terrain &terrain, const Columns &copters,
                    std::size_t copter, double largest);
    double margin_of(const Columns &copters, std::size_t copter) const;

    bool built_ = false;
    std::size_t loose_count_ = 0;
    std::vector<std::uint8_t> loose_;
    std::vector<Held> held_;
    HashGrid grid_;
};

} // namespace coptersim
