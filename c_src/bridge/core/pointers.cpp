#include "pointers.hpp"

#include <new>

namespace cb {

namespace {

constexpr std::uint64_t kGenerationUnit = std::uint64_t{1} << 32;
// Beyond this many, entries are numbered but no longer looked up: a program that hands out ever new
// addresses starts over instead of filling the memory.
constexpr std::size_t kMostEntries = 1U << 20;

} // namespace

std::uint64_t PointerTable::reference(void *address, const Type &pointee) {
    const Key key{address, &pointee};
    const auto known = known_.find(key);
    if (known != known_.end()) {
        return known->second;
    }
    if (entries_.size() >= kMostEntries && buffers_.empty()) {
        forget_all();
    }
    const std::uint64_t made = generation_ * kGenerationUnit + entries_.size();
    entries_.push_back(Entry{static_cast<unsigned char *>(address), &pointee, 0, false});
    known_[key] = made;
    return made;
}

std::uint64_t PointerTable::allocate(std::size_t bytes, const Type &pointee) {
    std::unique_ptr<void, Release> memory(std::calloc(1, bytes == 0 ? 1 : bytes));
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    const std::uint64_t made = reference(memory.get(), pointee);
    entries_[made % kGenerationUnit].bytes = bytes;
    buffers_[made] = std::move(memory);
    return made;
}

const PointerTable::Entry *PointerTable::find(std::uint64_t reference) const {
    const std::uint64_t index = reference % kGenerationUnit;
    if (reference / kGenerationUnit != generation_ || index >= entries_.size() ||
        entries_[index].freed) {
        return nullptr;
    }
    return &entries_[index];
}

bool PointerTable::free(std::uint64_t reference) {
    const auto buffer = buffers_.find(reference);
    if (buffer == buffers_.end()) {
        return false;
    }
    Entry &entry = entries_[reference % kGenerationUnit];
    known_.erase(Key{entry.address, entry.pointee});
    entry.freed = true;
    buffers_.erase(buffer);
    return true;
}

void PointerTable::forget_all() {
    ++generation_; // also if there are none: a forked child may have made some of this generation
    if (entries_.empty()) {
        return;
    }
    entries_.clear();
    known_.clear();
    buffers_.clear();
}

} // namespace cb
