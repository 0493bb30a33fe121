#include "advice.hpp"

namespace cb {

namespace {

// The heap is not part of a snapshot: what the library keeps there survives, and pointers to freed
// memory come back.
const char *const kHeapFunctions[] = {"malloc", "calloc",         "realloc", "free",
                                      "strdup", "posix_memalign", "_Znwm",   "_Znam",
                                      "_ZdlPv", "_ZdaPv",         "_ZdlPvm"};

// Entries of .init_array that are not the library's own: one of the compiler's start files, and
// those with which coverage and sanitizers register each source file.
std::size_t foreign_constructors(const DebugInfo *info) {
    return 1 + (info == nullptr ? 0
                                : info->count_functions_named("_sub_I_00") +
                                      info->count_functions_named("asan.module_ctor"));
}

} // namespace

std::vector<std::string> against_snapshot(const Mapped &library, const DebugInfo *info) {
    std::string imports;
    for (const char *function : kHeapFunctions) {
        if (library.imports(function)) {
            imports += (imports.empty() ? "" : ", ") + std::string(function);
        }
    }
    std::vector<std::string> reasons;
    if (!imports.empty()) {
        const bool counts = LoadedLibrary::symbol_of(library, "__gcov_dump") != nullptr;
        reasons.push_back(library.soname + " uses the heap (" + imports +
                          (counts ? "; perhaps only its coverage counters do" : "") +
                          "), which a snapshot does not reset");
    }
    if (library.constructors() > foreign_constructors(info)) {
        reasons.push_back(
            library.soname +
            " has constructors, whose work outside its own memory a snapshot does not reset");
    }
    return reasons;
}

} // namespace cb
