// The binary form of a recording.
//
// 8 bytes "FCREC001", then entries, all numbers little-endian and unaligned:
//   'N' u8 kind, u32 length, name                  names are numbered from 0 in the order of these
//   entries 'V' u8 type, u8 monitor, u32 name, u64 sequence, i64 time, u32 faults, before, after
//   'P' u8 put,  u8 0,       u32 name, u64 sequence, i64 time, u32 faults, before, after
// before and after are the bytes of a number; for FC_BYTES and packets u32 length and the bytes.
#pragma once

#include "fc_record.h"

#include <cstdint>
#include <string>
#include <vector>

namespace fc {

constexpr char kRecordingMagic[] = "FCREC001";
constexpr std::size_t kMagicSize = 8;

// Bytes of a number of that type; 0 for FC_BYTES.
std::size_t size_of_type(fc_type type);
const char *name_of_type(fc_type type);

struct RecordedName {
    bool is_channel;
    std::string text;
};

struct RecordedCall {
    fc_type type; // FC_BYTES for packets
    bool is_packet;
    bool flag; // monitor, or put
    std::uint32_t name;
    std::uint64_t sequence;
    std::int64_t time;
    std::uint32_t faults;
    const char *before;
    std::size_t before_size;
    const char *after;
    std::size_t after_size;
};

// Reads entry by entry and never beyond the end. The recording must outlive it.
class RecordingReader {
  public:
    RecordingReader(const void *data, std::size_t size);

    // True: *call is the next one. False: the end, or an error.
    bool next(RecordedCall *call);
    const std::vector<RecordedName> &names() const {
        return names_;
    }
    // Null, or what is wrong at position().
    const char *error() const {
        return error_;
    }
    std::size_t position() const {
        return at_;
    }

  private:
    template <class T> bool read(T *value);
    bool read_bytes(std::size_t size, const char **bytes);
    bool read_content(fc_type type, const char **bytes, std::size_t *size);
    bool read_name();
    bool read_call(bool is_packet, RecordedCall *call);
    bool fail(const char *why);

    const char *data_;
    std::size_t size_;
    std::size_t at_ = 0;
    std::vector<RecordedName> names_;
    const char *error_ = nullptr;
};

} // namespace fc
