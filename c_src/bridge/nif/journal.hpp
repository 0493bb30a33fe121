// A memory-mapped file of records that survives the death of the process. Layout:
// docs/architecture.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>

namespace cb {

class Journal {
  public:
    // Creates or empties the file. Throws std::system_error.
    Journal(const std::string &file, std::size_t bytes);
    ~Journal();
    Journal(const Journal &) = delete;
    Journal &operator=(const Journal &) = delete;

    // False when there is no room for it; the records so far stay.
    bool append(const void *record, std::size_t size);
    // Forgets all records, then appends.
    bool start(const void *record, std::size_t size);

  private:
    bool append_locked(const void *record, std::size_t size);
    void publish(std::uint64_t end);

    std::mutex mutex_;
    unsigned char *memory_ = nullptr;
    std::uint64_t size_ = 0;
    std::uint64_t end_ = 0;
};

} // namespace cb
