// failing_new.h: memory that runs out at a chosen allocation. The library takes its memory from
// operator new, which the one program that includes this replaces.
#pragma once

#include "errors.h"

#include <cstdlib>
#include <new>
#include <string>

namespace {

long allocations = 0;
long fail_at = -1; // the allocation that fails, counted from now; -1: none

void *allocate(std::size_t size, std::size_t alignment) {
    ++allocations;
    if (size > std::size_t{1} << 40)
        throw std::bad_alloc();
    if (fail_at >= 0 && fail_at-- == 0)
        throw std::bad_alloc();
    void *memory = nullptr;
    if (posix_memalign(&memory, alignment < sizeof(void *) ? sizeof(void *) : alignment,
                       size == 0 ? 1 : size) != 0)
        throw std::bad_alloc();
    return memory;
}

void *allocate_or_null(std::size_t size) {
    try {
        return allocate(size, 16);
    } catch (const std::bad_alloc &) {
        return nullptr;
    }
}

} // namespace

void *operator new(std::size_t size) {
    return allocate(size, 16);
}
void *operator new[](std::size_t size) {
    return allocate(size, 16);
}
void *operator new(std::size_t size, std::align_val_t alignment) {
    return allocate(size, static_cast<std::size_t>(alignment));
}
void *operator new[](std::size_t size, std::align_val_t alignment) {
    return allocate(size, static_cast<std::size_t>(alignment));
}
void *operator new(std::size_t size, const std::nothrow_t &) noexcept {
    return allocate_or_null(size);
}
void *operator new[](std::size_t size, const std::nothrow_t &) noexcept {
    return allocate_or_null(size);
}
void operator delete(void *memory) noexcept {
    std::free(memory);
}
void operator delete[](void *memory) noexcept {
    std::free(memory);
}
void operator delete(void *memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void *memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void *memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void *memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void *memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void *memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace {

// The listing of a context: everything that is armed or seen, with triggers and counters.
inline std::string listing_of(fc_context *ctx) {
    std::string text;
    fc_dump_json(
        ctx,
        [](void *user, const char *line) {
            *static_cast<std::string *>(user) += line + std::string("\n");
        },
        &text);
    return text;
}

// What a call leaves when it goes through.
template <class Prepare, class Work> std::string listing_after(Prepare prepare, Work work) {
    fc_context *ctx = fc_new(nullptr);
    errors_start(ctx);
    prepare(ctx);
    CHECK(work(ctx) >= 0);
    CHECK_NO_ERROR();
    std::string listing = listing_of(ctx);
    fc_free(ctx);
    return listing;
}

// Runs work once for every allocation it makes, that one failing, until it goes through. work
// returns an fc_ result. A call that fails leaves the listing as it was, and when it is made again
// it leaves what it leaves without a failure. Returns the number of allocations.
template <class Prepare, class Work, class Unchanged>
int fail_each(Prepare prepare, Work work, Unchanged unchanged) {
    const std::string expected = listing_after(prepare, work);
    for (int failing = 0; failing < 200; ++failing) {
        fc_context *ctx = fc_new(nullptr);
        errors_start(ctx);
        prepare(ctx);
        const std::string before = listing_of(ctx);
        fail_at = failing;
        const long long result = work(ctx);
        const bool failed = fail_at < 0;
        fail_at = -1;
        if (failed) {
            CHECK_INT(result, FC_E_NOMEM);
            CHECK_ERROR(FC_E_NOMEM, "memory");
            CHECK(listing_of(ctx) == before);
            unchanged(ctx);
            CHECK(work(ctx) >= 0);
        } else {
            CHECK(result >= 0);
            CHECK_INT(errors_seen, 0);
        }
        CHECK(listing_of(ctx) == expected);
        fc_free(ctx);
        if (!failed)
            return failing;
    }
    CHECK(!"a call that never succeeds");
    return 0;
}

} // namespace
