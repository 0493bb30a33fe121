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
        of_types_.push_back({type, std::string(static_cast<const char *>(bytes), size), {}, 0});
        return of_types_.back();
    }

    std::int64_t first_time = 0; // DRIFT_TIMED, HELD_OFFSET: of the window's first call
    std::int64_t period = 0;     // HELD_OFFSET: the number of the one it was drawn in
    double unit = 0;             // HELD_OFFSET: drawn last

  private:
    bool open_ = false;
    std::uint64_t calls_ = 0;
    std::vector<OfType> of_types_;
};

} // namespace fc
