// Which builds of the hot loops the machine can run.
#include "hot_loops.h"

#include <cstring>

namespace coptersim {

#if defined(__x86_64__)
extern const HotLoops hot_loops_sse2, hot_loops_avx2, hot_loops_avx512;
#else
extern const HotLoops hot_loops_plain;
#endif

const HotLoops *hot_loops_at(int index) {
#if defined(__x86_64__)
    switch (index) {
    case 0:
        return &hot_loops_sse2;
    case 1:
        return __builtin_cpu_supports("avx2") ? &hot_loops_avx2 : nullptr;
    case 2:
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                       __builtin_cpu_supports("avx512vl")
                   ? &hot_loops_avx512
                   : nullptr;
    default:
        return nullptr;
    }
#else
    return index == 0 ? &hot_loops_plain : nullptr;
#endif
}

const HotLoops *find_hot_loops(const char *name) {
    const HotLoops *found = nullptr;
    for (int i = 0; const HotLoops *loops = hot_loops_at(i); ++i)
        if (name == nullptr || std::strcmp(loops->name, name) == 0)
            found = loops;
    return found;
}

} // namespace coptersim
