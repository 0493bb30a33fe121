/* log_file.cpp: events of LCM's log format: a header of 28 bytes, channel, data; big endian. */
#include "log_file.hpp"

#include <cerrno>
#include <cstring>
#include <sys/stat.h>
#include <unistd.h>

namespace coptersim_stream {
namespace {

constexpr std::uint32_t event_magic = 0xeda1da01;

/* Devices, pipes and links (/dev/stdout is one) are not replaced by a complete file. */
bool is_special(const std::string &file) {
    struct stat status;
    return lstat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

void append(std::string &to, std::uint64_t value, int bytes) {
    for (int shift = 8 * (bytes - 1); shift >= 0; shift -= 8) {
        to += static_cast<char>(value >> shift & 0xff);
    }
}

} // namespace

log_file::~log_file() {
    if (stream_ != nullptr) {
        std::fclose(stream_);
        if (!temporary_.empty()) {
            std::remove(temporary_.c_str());
        }
    }
}

bool log_file::failed(std::string &error) const {
    error = file_ + ": " + std::strerror(errno);
    return false;
}

bool log_file::open(const std::string &file, std::string &error) {
    file_ = file;
    temporary_ = is_special(file) ? "" : file + ".part." + std::to_string(getpid());
    stream_ = std::fopen(temporary_.empty() ? file.c_str() : temporary_.c_str(), "wb");
    return stream_ != nullptr || failed(error);
}

bool log_file::put(std::uint64_t t_us, const char *channel, std::string_view bytes,
                   std::string &error) {
    std::string event;
    append(event, event_magic, 4);
    append(event, number_++, 8);
    append(event, t_us, 8);
    append(event, std::strlen(channel), 4);
    append(event, bytes.size(), 4);
    event += channel;
    event += bytes;
    return std::fwrite(event.data(), 1, event.size(), stream_) == event.size() || failed(error);
}

bool log_file::finish(std::string &error) {
    bool good = std::fflush(stream_) == 0 || failed(error);
    good = (std::fclose(stream_) == 0 || (good && failed(error))) && good;
    stream_ = nullptr;
    if (temporary_.empty()) {
        return good;
    }
    good = good && (std::rename(temporary_.c_str(), file_.c_str()) == 0 || failed(error));
    if (!good) {
        std::remove(temporary_.c_str());
    }
    return good;
}

} // namespace coptersim_stream
