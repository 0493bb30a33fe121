#include "session.hpp"

#include "advice.hpp"
#include "error.hpp"
#include "stub.hpp"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace cb {

namespace {

[[noreturn]] void load_failure(const std::string &file, Tree why) {
    fail("load", Tree::binary(file), std::move(why));
}

std::unique_ptr<DebugInfo> open_debug_info(const std::string &file, bool required) {
    struct stat status;
    if (stat(file.c_str(), &status) != 0) {
        load_failure(file,
                     Tree::tuple({Tree::atom("dlerror"), Tree::binary(std::strerror(errno))}));
    }
    if (!S_ISREG(status.st_mode)) { // reading a pipe or a device might never end
        load_failure(file, Tree::tuple({Tree::atom("dlerror"), Tree::binary("not a file")}));
    }
    std::string why;
    std::unique_ptr<DebugInfo> info = DebugInfo::open(file, why);
    if (info == nullptr && required) {
        load_failure(file, why.empty()
                               ? Tree::atom("no_debug_info")
                               : Tree::tuple({Tree::atom("debug_info"), Tree::binary(why)}));
    }
    return info;
}

} // namespace

Session::Session(const std::string &file, const LoadOptions &options)
    : types_([this](const std::string &name, int tag) { return find_type(name, tag); }) {
    pointers_.begin_at(options.generation);
    const bool has_signatures = !options.signatures.empty();
    std::unique_ptr<DebugInfo> main = open_debug_info(file, !has_signatures);
    if (has_signatures) {
        signatures_ = open_debug_info(options.signatures, true);
    }
    library_ = std::make_unique<LoadedLibrary>(file);
    load_parts(options, std::move(main));
    note_memory();
}

Session::~Session() = default;

void Session::load_parts(const LoadOptions &options, std::unique_ptr<DebugInfo> main) {
    const std::vector<Mapped> &all = library_->all();
    parts_.push_back(Part{all.front(), std::move(main), {}});
    for (std::size_t i = 1; i < all.size(); ++i) {
        const auto &left_alone = options.no_index;
        if (std::find(left_alone.begin(), left_alone.end(), all[i].soname) != left_alone.end()) {
            continue;
        }
        // A library without debug information is somebody else's: neither called nor reset.
        std::string why;
        std::unique_ptr<DebugInfo> info = DebugInfo::open(all[i].file, why);
        if (info != nullptr) {
            parts_.push_back(Part{all[i], std::move(info), {}});
        }
    }
    for (std::size_t i = 1; i < parts_.size(); ++i) {
        Part &part = parts_[i];
        part.pristine.take(part.mapped.writable(), part.counters());
    }
}

Tree Session::description() const {
    std::vector<Tree> libraries;
    std::vector<Tree> warnings;
    bool heap_or_constructors = false;
    for (const Part &part : parts_) {
        libraries.push_back(Tree::binary(part.mapped.file));
        for (const std::string &reason : against_snapshot(part.mapped, part.info.get())) {
            warnings.push_back(Tree::binary(reason));
            heap_or_constructors = true;
        }
    }
    if (library_->copied()) {
        warnings.push_back(Tree::binary(parts_.front().mapped.soname +
                                        " was loaded already: a copy of it was loaded, but the "
                                        "libraries it needs are shared"));
    }
    return Tree::map({Tree::atom("file"), Tree::binary(library_->file()), Tree::atom("libraries"),
                      Tree::list(std::move(libraries)), Tree::atom("reset"),
                      Tree::atom(heap_or_constructors ? "reload" : "snapshot"),
                      Tree::atom("warnings"), Tree::list(std::move(warnings))});
}

std::vector<Range> Session::Part::counters() const {
    std::vector<Range> ranges;
    for (const char *prefix : {"__gcov", "__llvm_gcov"}) {
        for (const DebugInfo::Symbol &symbol :
             info != nullptr ? info->objects_named(prefix) : std::vector<DebugInfo::Symbol>{}) {
            ranges.push_back(Range{reinterpret_cast<unsigned char *>(mapped.bias + symbol.address),
                                   symbol.size});
        }
    }
    return ranges;
}

void Session::note_memory() {
    for (const Part &part : parts_) {
        connect_stubs(part.mapped);
    }
    writable_.clear();
    mapped_.clear();
    for (const Part &part : parts_) {
        const std::vector<Range> own = part.mapped.writable();
        writable_.insert(writable_.end(), own.begin(), own.end());
        mapped_.push_back(part.mapped.extent());
    }
}

bool Session::is_read_only(const unsigned char *address) const {
    const auto inside = [&](const Range &range) { return range.contains(address); };
    return std::any_of(mapped_.begin(), mapped_.end(), inside) &&
           std::none_of(writable_.begin(), writable_.end(), inside);
}

unsigned char *Session::address_in_memory(const FilePlace &place) const {
    if (!place.symbol.empty()) {
        return static_cast<unsigned char *>(library_->symbol(place.symbol.c_str()));
    }
    return reinterpret_cast<unsigned char *>(parts_[place.part].mapped.bias + place.address);
}

void Session::take_snapshot() {
    std::vector<Range> counters;
    for (const Part &part : parts_) {
        const std::vector<Range> own = part.counters();
        counters.insert(counters.end(), own.begin(), own.end());
    }
    snapshot_.take(writable_, std::move(counters));
}

void Session::restore() {
    if (!snapshot_.restore()) {
        fail("no_snapshot");
    }
    forget_pointers();
}

void Session::forget_pointers() {
    pointers_.forget_all();
    kept_.clear();
}

void Session::reload() {
    flush_coverage();
    snapshot_.clear();
    forget_pointers();
    relocate(library_->reload());
    note_memory();
}

// After a reload: the same files may lie elsewhere. What stayed in memory gets its first state
// back.
void Session::relocate(const std::vector<std::string> &pinned) {
    const std::vector<Mapped> &all = library_->all();
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        Part &part = parts_[i];
        const auto same = [&](const Mapped &mapped) {
            return mapped.soname == part.mapped.soname || (i == 0 && &mapped == &all.front());
        };
        const auto found = std::find_if(all.begin(), all.end(), same);
        if (found == all.end()) {
            load_failure(part.mapped.file,
                         Tree::tuple({Tree::atom("dlerror"), Tree::binary("gone after a reload")}));
        }
        const bool stayed = found->bias == part.mapped.bias &&
                            std::find(pinned.begin(), pinned.end(), found->soname) != pinned.end();
        part.mapped = *found;
        if (stayed) {
            part.pristine.restore();
        } else if (i > 0) {
            part.pristine.take(part.mapped.writable(), part.counters());
        }
    }
    for (const auto &known : known_functions_) {
        known->function->address = address_in_memory(known->place);
    }
}

} // namespace cb
