#include "recording.h"

#include <cstring>

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__,
              "numbers are copied as they are in memory");

namespace fc {

std::size_t size_of_type(fc_type type) {
    constexpr std::size_t sizes[] = {4, 8, 1, 2, 4, 8, 1, 2, 4, 8, 1, 0};
    return sizes[type];
}

const char *name_of_type(fc_type type) {
    constexpr const char *names[] = {"f32", "f64", "i8",  "i16", "i32",  "i64",
                                     "u8",  "u16", "u32", "u64", "bool", "bytes"};
    return names[type];
}

RecordingReader::RecordingReader(const void *data, std::size_t size)
    : data_(static_cast<const char *>(data)), size_(size) {
    if (size < kMagicSize || std::memcmp(data, kRecordingMagic, kMagicSize) != 0)
        fail("it does not begin with FCREC001");
    else
        at_ = kMagicSize;
}

bool RecordingReader::next(RecordedCall *call) {
    while (error_ == nullptr && at_ < size_) {
        const std::size_t start = at_;
        const char tag = data_[at_++];
        bool good = false;
        if (tag == 'N')
            good = read_name();
        else if (tag == 'V' || tag == 'P')
            good = read_call(tag == 'P', call);
        else
            fail("an entry of an unknown kind");
        if (!good) {
            at_ = start;
            if (error_ == nullptr)
                fail("an entry is cut off");
            return false;
        }
        if (tag != 'N')
            return true;
    }
    return false;
}

template <class T> bool RecordingReader::read(T *value) {
    const char *bytes;
    if (!read_bytes(sizeof(T), &bytes))
        return false;
    std::memcpy(value, bytes, sizeof(T));
    return true;
}

bool RecordingReader::read_bytes(std::size_t size, const char **bytes) {
    if (size > size_ - at_)
        return false;
    *bytes = data_ + at_;
    at_ += size;
    return true;
}

bool RecordingReader::read_content(fc_type type, const char **bytes, std::size_t *size) {
    std::uint32_t length = static_cast<std::uint32_t>(size_of_type(type));
    if (type == FC_BYTES && !read(&length))
        return false;
    *size = length;
    return read_bytes(length, bytes);
}

bool RecordingReader::read_name() {
    std::uint8_t is_channel;
    std::uint32_t length;
    const char *bytes;
    if (!read(&is_channel) || !read(&length) || !read_bytes(length, &bytes))
        return false;
    if (is_channel > 1)
        return fail("a name that is neither of a probe nor of a channel");
    names_.push_back({is_channel == 1, std::string(bytes, length)});
    return true;
}

bool RecordingReader::read_call(bool is_packet, RecordedCall *call) {
    std::uint8_t first;
    std::uint8_t second;
    if (!read(&first) || !read(&second) || !read(&call->name) || !read(&call->sequence) ||
        !read(&call->time) || !read(&call->faults))
        return false;
    if (!is_packet && first > FC_BYTES)
        return fail("a value of an unknown type");
    if (call->name >= names_.size())
        return fail("a name that has not been told");
    call->is_packet = is_packet;
    call->type = is_packet ? FC_BYTES : static_cast<fc_type>(first);
    call->flag = (is_packet ? first : second) != 0;
    return read_content(call->type, &call->before, &call->before_size) &&
           read_content(call->type, &call->after, &call->after_size);
}

bool RecordingReader::fail(const char *why) {
    error_ = why;
    return false;
}

} // namespace fc
