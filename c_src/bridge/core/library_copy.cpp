#include "library_copy.hpp"

#include "error.hpp"
#include "library.hpp"

#include <fcntl.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace cb {

namespace {

// Names of copies are looked up by the crash handler: fixed memory, written before it is published.
// A path keeps its slot for the life of the process; there are as many slots as files ever copied,
// not as copies.
struct CopiedFile {
    char stem[512]; // the copy's path without its unique end
    char original[512];
};
std::array<CopiedFile, 64> copied_files;
std::atomic<std::size_t> copied_count{0};

constexpr std::size_t kUniqueEnd = 6; // of mkstemp

void remember(const std::string &stem, const std::string &original) {
    const std::size_t count = copied_count.load();
    for (std::size_t i = 0; i < count; ++i) {
        if (stem == copied_files[i].stem) {
            return;
        }
    }
    if (count < copied_files.size() && stem.size() < sizeof(CopiedFile::stem) &&
        original.size() < sizeof(CopiedFile::original)) {
        std::memcpy(copied_files[count].stem, stem.c_str(), stem.size() + 1);
        std::memcpy(copied_files[count].original, original.c_str(), original.size() + 1);
        copied_count.store(count + 1);
    }
}

int make_file(const std::string &folder, const std::string &name, std::string &path) {
    path = folder + "/." + name + ".XXXXXX";
    return mkostemp(path.data(), O_CLOEXEC);
}

bool copy_bytes(int from, int to) {
    struct stat status;
    if (fstat(from, &status) != 0) {
        return false;
    }
    auto left = static_cast<std::size_t>(status.st_size);
    while (left > 0) {
        const ssize_t sent = sendfile(to, from, nullptr, left);
        if (sent <= 0) {
            return false;
        }
        left -= static_cast<std::size_t>(sent);
    }
    return true;
}

[[noreturn]] void cannot_copy(const std::string &file) {
    const std::string text = "cannot make a copy: " + std::string(std::strerror(errno));
    fail("load", Tree::binary(file), Tree::tuple({Tree::atom("dlerror"), Tree::binary(text)}));
}

} // namespace

TemporaryCopy::TemporaryCopy(const std::string &file) {
    const std::size_t slash = file.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : file.substr(0, slash);
    const std::string name = slash == std::string::npos ? file : file.substr(slash + 1);
    const char *temporary = std::getenv("TMPDIR");
    const int from = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (from < 0) {
        cannot_copy(file);
    }
    int to = make_file(folder, name, path_);
    if (to < 0) {
        to = make_file(temporary != nullptr ? temporary : "/tmp", name, path_);
    }
    const bool copied = to >= 0 && copy_bytes(from, to);
    ::close(from);
    if (to >= 0) {
        ::close(to);
    }
    if (!copied) {
        if (to >= 0) {
            unlink(path_.c_str());
        }
        cannot_copy(file);
    }
    remember(path_.substr(0, path_.size() - kUniqueEnd), file);
}

TemporaryCopy::~TemporaryCopy() {
    unlink(path_.c_str());
}

const char *original_file(const char *path) {
    const std::size_t length = std::strlen(path);
    const std::size_t count = copied_count.load();
    for (std::size_t i = 0; i < count; ++i) {
        const char *stem = copied_files[i].stem;
        const std::size_t stem_length = std::strlen(stem);
        if (length == stem_length + kUniqueEnd && std::strncmp(path, stem, stem_length) == 0) {
            return copied_files[i].original;
        }
    }
    return path;
}

} // namespace cb
