#include "recorder.h"

#include <algorithm>
#include <new>
#include <stdexcept>

namespace fc {

namespace {

using Hold = std::lock_guard<SpinLock>;
constexpr std::size_t kFirstBuffer = 1 << 16;
constexpr std::size_t kHeadSize = 1 + 1 + 1 + 4 + 8 + 8 + 4;

std::size_t content_size(const RecordedContent &content) {
    return 4 + content.size;
}

} // namespace

int Recorder::start(const char *file) {
    std::FILE *opened = nullptr;
    if (file != nullptr && (opened = std::fopen(file, "wb")) == nullptr)
        return FC_E_IO;
    stop();
    const Hold hold(lock_);
    file_ = opened;
    failure_ = FC_OK;
    names_ = 0;
    sequence_ = 0;
    ++recording_;
    buffer_.clear();
    end_ = nullptr;
    if (!make_room(kMagicSize))
        return FC_E_NOMEM;
    put(kRecordingMagic, kMagicSize);
    on_ = true;
    return FC_OK;
}

int Recorder::stop() {
    const Hold hold(lock_);
    if (!on_)
        return FC_OK;
    on_ = false;
    if (file_ != nullptr) {
        flush();
        if (std::fclose(file_) != 0)
            failure_ = FC_E_IO;
        file_ = nullptr;
    }
    return failure_;
}

void Recorder::clear() {
    stop();
    const Hold hold(lock_);
    std::string().swap(buffer_);
    end_ = nullptr;
}

std::size_t Recorder::copy(void *data, std::size_t capacity) const {
    const Hold hold(lock_);
    if (end_ == nullptr || file_ != nullptr)
        return 0;
    const auto size = static_cast<std::size_t>(end_ - buffer_.data());
    if (const std::size_t part = std::min(size, capacity); part > 0)
        std::memcpy(data, buffer_.data(), part);
    return size;
}

void Recorder::write(const std::string &name, RecordedAs *as, const Call &call) {
    const Hold hold(lock_);
    if (!on_)
        return;
    const bool is_new = as->recording != recording_;
    const std::size_t size = (is_new ? 6 + name.size() : 0) + kHeadSize +
                             content_size(call.before) + content_size(call.after);
    if (!make_room(size))
        return;
    if (is_new) {
        *as = {recording_, names_++};
        put('N');
        put(static_cast<std::uint8_t>(call.is_packet ? 1 : 0));
        put(static_cast<std::uint32_t>(name.size()));
        put(name.data(), name.size());
    }
    put(call.is_packet ? 'P' : 'V');
    put(static_cast<std::uint8_t>(call.is_packet ? call.flag : static_cast<int>(call.type)));
    put(static_cast<std::uint8_t>(call.is_packet ? 0 : call.flag));
    put(as->name);
    put(sequence_++);
    put(call.time);
    put(call.faults);
    put_content(call.type, call.before);
    put_content(call.type, call.after);
}

void Recorder::put_content(fc_type type, const RecordedContent &content) {
    if (type == FC_BYTES)
        put(static_cast<std::uint32_t>(content.size));
    if (content.size > 0)
        put(content.bytes, content.size);
}

bool Recorder::make_room(std::size_t size) {
    const char *limit = buffer_.data() + buffer_.size();
    if (end_ != nullptr && size <= static_cast<std::size_t>(limit - end_))
        return true;
    return grow(size);
}

bool Recorder::grow(std::size_t size) {
    if (file_ != nullptr)
        flush();
    const std::size_t used = end_ == nullptr ? 0 : static_cast<std::size_t>(end_ - buffer_.data());
    if (size <= buffer_.size() - used)
        return true;
    try {
        buffer_.resize(std::max({kFirstBuffer, 2 * buffer_.size(), used + size}));
    } catch (const std::bad_alloc &) {
        failure_ = FC_E_NOMEM;
        return false;
    } catch (const std::length_error &) {
        failure_ = FC_E_NOMEM;
        return false;
    }
    end_ = &buffer_[0] + used;
    return true;
}

void Recorder::flush() {
    if (end_ == nullptr)
        return;
    const auto size = static_cast<std::size_t>(end_ - buffer_.data());
    if (std::fwrite(buffer_.data(), 1, size, file_) != size)
        failure_ = FC_E_IO;
    end_ = &buffer_[0];
}

} // namespace fc
