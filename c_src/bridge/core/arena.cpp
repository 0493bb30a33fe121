#include "arena.hpp"

#include "sanitizer.hpp"

#include <cstdlib>
#include <cstring>
#include <new>

namespace cb {

Arena::Arena() : first_(new unsigned char[kFirstBlock]), separate_(under_address_sanitizer()) {}

void Arena::Free::operator()(void *memory) const {
    std::free(memory);
}

void *Arena::take(std::size_t bytes) {
    return std::memset(take_raw(bytes), 0, bytes);
}

void *Arena::take_raw(std::size_t bytes) {
    const std::size_t rounded = (bytes + 15) & ~std::size_t{15};
    if (!separate_ && rounded <= kFirstBlock - used_) {
        unsigned char *place = first_.get() + used_;
        used_ += rounded;
        return place;
    }
    void *memory = std::malloc(bytes == 0 ? 1 : bytes);
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    extra_.emplace_back(memory);
    return memory;
}

} // namespace cb
