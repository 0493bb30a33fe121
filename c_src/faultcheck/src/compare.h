// The differences between a golden recording and a run.
#pragma once

#include "recording.h"

#include <cstdint>

namespace fc {

struct Divergence {
    RecordedName name;
    fc_divergence found;
    std::uint64_t order; // sequence number of the first divergence in the run; after all of them if
                         // it is missing there
};

// In the order of the first divergences. Both readers stand at their beginning; an error is left in
// them.
std::vector<Divergence> compare(RecordingReader &golden, RecordingReader &run,
                                const fc_tolerance &tolerance);

} // namespace fc
