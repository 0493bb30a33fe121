// Pointers as the caller sees them: numbers that mean nothing after a reset.
#pragma once

#include "type.hpp"

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <unordered_map>
#include <vector>

namespace cb {

class PointerTable {
  public:
    struct Entry {
        unsigned char *address = nullptr;
        const Type *pointee = nullptr;
        std::size_t bytes = 0; // size of a buffer of ours, 0: not ours
        bool freed = false;
    };

    // The reference of an address; the same address and type give the same reference.
    std::uint64_t reference(void *address, const Type &pointee);
    // A zeroed buffer that lives until free() or forget_all(). Throws std::bad_alloc.
    std::uint64_t allocate(std::size_t bytes, const Type &pointee);
    // nullptr if the reference is unknown, freed or from before the last forget_all().
    const Entry *find(std::uint64_t reference) const;
    // False if it is not a live buffer of ours.
    bool free(std::uint64_t reference);
    void forget_all();
    // The number of the generation that begins, above those of an earlier process.
    void begin_at(std::uint64_t generation) {
        generation_ = generation;
    }

  private:
    struct Key {
        void *address;
        const Type *pointee;
        bool operator==(const Key &other) const {
            return address == other.address && pointee == other.pointee;
        }
    };
    struct KeyHash {
        std::size_t operator()(const Key &key) const {
            return std::hash<void *>()(key.address) * 31 + std::hash<const void *>()(key.pointee);
        }
    };
    struct Release {
        void operator()(void *memory) const {
            std::free(memory);
        }
    };

    std::vector<Entry> entries_;
    std::unordered_map<Key, std::uint64_t, KeyHash> known_;
    std::unordered_map<std::uint64_t, std::unique_ptr<void, Release>> buffers_;
    std::uint64_t generation_ = 1;
};

} // namespace cb
