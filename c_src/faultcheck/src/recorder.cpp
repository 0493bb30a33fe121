#include "recorder.h"

#include <algorithm>
#include <new>

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
    end_ = buffer_.get();
    if (!make_room(kMagicSize)) {
        if (file_ != nullptr)
            std::fclose(file_);
        file_ = nullptr;
        return FC_E_NOMEM;
    }
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
    buffer_.reset();
    end_ = limit_ = nullptr;
}

std::size_t Recorder::copy(void *data, std::size_t capacity) const {
    const Hold hold(lock_);
    if (end_ == nullptr || file_ != nullptr)
        return 0;
    const auto size = static_cast<std::size_t>(end_ - buffer_.get());
    if (const std::size_t part = std::min(size, capacity); part > 0 && data != nullptr)
        std::memcpy(data, buffer_.get(), part);
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
    return size <= static_cast<std::size_t>(limit_ - end_) || grow(size);
}

bool Recorder::grow(std::size_t size) {
    if (file_ != nullptr)
        flush();
    const auto used = static_cast<std::size_t>(end_ - buffer_.get());
    const auto capacity = static_cast<std::size_t>(limit_ - buffer_.get());
    if (size <= capacity - used)
        return true;
    const std::size_t larger = std::max({kFirstBuffer, 2 * capacity, used + size});
    std::unique_ptr<char[]> next(new (std::nothrow) char[larger]);
    if (next == nullptr) {
        failure_ = FC_E_NOMEM;
        return false;
    }
    if (used > 0)
        std::memcpy(next.get(), buffer_.get(), used);
    buffer_ = std::move(next);
    end_ = buffer_.get() + used;
    limit_ = buffer_.get() + larger;
    return true;
}

void Recorder::flush() {
    const auto size = static_cast<std::size_t>(end_ - buffer_.get());
    if (size > 0 && std::fwrite(buffer_.get(), 1, size, file_) != size)
        failure_ = FC_E_IO;
    end_ = buffer_.get();
}

} // namespace fc
