#include "journal.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <system_error>

namespace cb {

namespace {

constexpr char kMagic[] = "FCJRNL1\n";
constexpr std::size_t kEndAt = 8;
constexpr std::size_t kHeader = 16;

[[noreturn]] void system_failure(int code) {
    throw std::system_error(code, std::generic_category());
}

} // namespace

Journal::Journal(const std::string &file, std::size_t bytes) : size_(std::max(bytes, kHeader)) {
    const int fd = open(file.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (fd < 0) {
        system_failure(errno);
    }
    // Blocks are reserved now: a disk that is full later would end the process with SIGBUS.
    const int reserved = posix_fallocate(fd, 0, static_cast<off_t>(size_));
    void *mapped = reserved == 0 ? mmap(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0)
                                 : MAP_FAILED;
    const int code = reserved != 0 ? reserved : errno;
    close(fd);
    if (mapped == MAP_FAILED) {
        system_failure(code);
    }
    memory_ = static_cast<unsigned char *>(mapped);
    publish(kHeader);
    std::memcpy(memory_, kMagic, kEndAt);
}

Journal::~Journal() {
    munmap(memory_, size_);
}

// The end is written after the record it covers, so that what a reader sees is complete.
void Journal::publish(std::uint64_t end) {
    end_ = end;
    __atomic_store_n(reinterpret_cast<std::uint64_t *>(memory_ + kEndAt), end, __ATOMIC_RELEASE);
}

bool Journal::append(const void *record, std::size_t size) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return append_locked(record, size);
}

bool Journal::start(const void *record, std::size_t size) {
    const std::lock_guard<std::mutex> lock(mutex_);
    publish(kHeader);
    return append_locked(record, size);
}

bool Journal::append_locked(const void *record, std::size_t size) {
    if (size > std::numeric_limits<std::uint32_t>::max() || size + 4 > size_ - end_) {
        return false;
    }
    const auto length = static_cast<std::uint32_t>(size); // little-endian, as the processor
    std::memcpy(memory_ + end_, &length, sizeof length);
    std::memcpy(memory_ + end_ + sizeof length, record, size);
    publish(end_ + sizeof length + size);
    return true;
}

} // namespace cb
