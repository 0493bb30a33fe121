/* output.cpp: a trace to a file or to standard output. */
#include "output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <sys/stat.h>

namespace coptersim_run {
namespace {

/* A device, a pipe or a link is written to; /dev/stdout must not be replaced by a complete file. */
bool is_special(const std::string &file) {
    struct stat status;
    return lstat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode);
}

bool write_to(std::FILE *stream, const csim_trace::trace &t, bool csv) {
    bool good = true;
    auto out = [&](std::string_view text) {
        good = good && std::fwrite(text.data(), 1, text.size(), stream) == text.size();
    };
    if (csv) {
        csim_trace::write_csv(t, out);
    } else {
        csim_trace::write_json(t, out);
    }
    return good && std::fflush(stream) == 0;
}

bool failed(const std::string &what, std::string &error) {
    error = what + ": " + std::strerror(errno);
    return false;
}

} // namespace

bool write_trace(const csim_trace::trace &t, bool csv, const std::string &file,
                 std::string &error) {
    if (file.empty()) {
        return write_to(stdout, t, csv) || failed("standard output", error);
    }
    bool direct = is_special(file);
    std::string name = direct ? file : file + ".part";
    std::FILE *stream = std::fopen(name.c_str(), "wb");
    if (stream == nullptr) {
        return failed(file, error);
    }
    bool good = write_to(stream, t, csv) || failed(file, error);
    good = (std::fclose(stream) == 0 || (good && failed(file, error))) && good;
    if (!direct && good) {
        good = std::rename(name.c_str(), file.c_str()) == 0 || failed(file, error);
    }
    if (!direct && !good) {
        std::remove(name.c_str());
    }
    return good;
}

} // namespace coptersim_run
