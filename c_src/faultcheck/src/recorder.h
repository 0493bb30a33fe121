// Writes a context's recording.
#pragma once

#include "recording.h"
#include "spin_lock.h"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <mutex>

namespace fc {

// Where a probe or channel stands in the recording under way.
struct RecordedAs {
    std::uint32_t recording = 0; // number of the recording it has a name in
    std::uint32_t name = 0;
};

struct RecordedContent {
    const void *bytes;
    std::size_t size;
};

class Recorder {
  public:
    ~Recorder() {
        stop();
    }

    // FC_OK, FC_E_IO, FC_E_NOMEM.
    int start(const char *file);
    int stop();
    void clear();
    std::size_t copy(void *data, std::size_t capacity) const;

    // Any thread, under the identifier's lock. A value that memory or file has no room for is
    // missing, which stop() tells.
    struct Call {
        bool is_packet;
        fc_type type;
        bool flag;
        std::int64_t time;
        std::uint32_t faults;
        RecordedContent before;
        RecordedContent after;
    };
    void write(const std::string &name, RecordedAs *as, const Call &call);

  private:
    void put(const void *bytes, std::size_t size) {
        std::memcpy(end_, bytes, size);
        end_ += size;
    }
    template <class T> void put(const T &value) {
        put(&value, sizeof value);
    }
    bool make_room(std::size_t size);
    bool grow(std::size_t size);
    void flush();
    void put_content(fc_type type, const RecordedContent &content);

    mutable SpinLock lock_;
    bool on_ = false;
    int failure_ = FC_OK;
    std::uint32_t recording_ = 0;
    std::uint32_t names_ = 0;
    std::uint64_t sequence_ = 0;
    std::FILE *file_ = nullptr; // null: to memory
    std::unique_ptr<char[]> buffer_;
    char *end_ = nullptr;   // of what is written
    char *limit_ = nullptr; // of the buffer
};

} // namespace fc
