// What a model remembers between the affected calls of a window, for one receiver.
#pragma once

#include "fc.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fc {

// A window starts at the first affected call after arming, after a change of the trigger or after
// an unaffected call.
class ModelState {
  public:
    // Per probed type: an identifier may be probed as several.
    struct OfType {
        fc_type type;
        std::string held;                 // STUCK, RAMP, DROPOUT
        std::vector<std::string> history; // DELAY: a ring of at most n inputs
        std::uint64_t inputs = 0;         // DELAY: so far
    };

    void end_window() {
        if (open_) {
            open_ = false;
            calls_ = 0;
            of_types_.clear();
        }
    }

    // An affected call passes: returns k, the number of those before it in the window.
    std::uint64_t next_call() {
        open_ = true;
        return calls_++;
    }

    // Null before the window's first affected call of this type.
    OfType *find(fc_type type) {
        for (OfType &entry : of_types_)
            if (entry.type == type)
                return &entry;
        return nullptr;
    }
    OfType &add(fc_type type, const void *bytes, std::size_t size) {
        open_ = true;
        spare_.type = type;
        spare_.held.assign(static_cast<const char *>(bytes), size);
        of_types_.push_back(std::move(spare_));
        spare_ = OfType();
        return of_types_.back();
    }

    // Takes the memory that a call may need: after it, add() and remember() with a value of that
    // type and size cannot fail. n: how many inputs are kept at most.
    void prepare(fc_type type, std::size_t size, std::uint64_t n) {
        OfType *known = find(type);
        if (known == nullptr) {
            make_room(of_types_);
            spare_.held.reserve(size);
            known = &spare_;
        }
        if (n > 0)
            input_.reserve(size);
        if (known->inputs < n)
            make_room(known->history);
    }

    // DELAY by n calls, n > 0: keeps the input and gives the one that is due, which stays as it is
    // until the next call.
    const std::string &remember(OfType &known, std::uint64_t n, const void *bytes,
                                std::size_t size) {
        const auto *input = static_cast<const char *>(bytes);
        input_.assign(input, size);
        if (known.inputs++ < n) {
            known.history.push_back(std::move(input_));
            input_ = std::string();
            return known.history.front();
        }
        input_.swap(known.history[static_cast<std::size_t>((known.inputs - 1) % n)]);
        return input_;
    }

    std::int64_t first_time = 0; // DRIFT_TIMED, HELD_OFFSET: of the window's first call
    std::int64_t period = 0;     // HELD_OFFSET: the number of the one it was drawn in
    double unit = 0;             // HELD_OFFSET: drawn last

  private:
    template <class T> static void make_room(std::vector<T> &values) {
        if (values.size() == values.capacity())
            values.reserve(2 * values.size() + 1);
    }

    bool open_ = false;
    std::uint64_t calls_ = 0;
    std::vector<OfType> of_types_;
    OfType spare_ = {}; // the next one
    std::string input_; // room for a value
};

} // namespace fc
