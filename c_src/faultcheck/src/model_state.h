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
    void end_window() {
        if (!held_.empty())
            held_.clear();
    }

    // The value that entered at the window's first affected call of this type, or null before it.
    const std::string *held(fc_type type) const {
        for (const Held &entry : held_)
            if (entry.type == type)
                return &entry.bytes;
        return nullptr;
    }
    void hold(fc_type type, const void *bytes, std::size_t size) {
        held_.push_back({type, std::string(static_cast<const char *>(bytes), size)});
    }

  private:
    struct Held {
        fc_type type;
        std::string bytes;
    };
    std::vector<Held> held_;
};

} // namespace fc
