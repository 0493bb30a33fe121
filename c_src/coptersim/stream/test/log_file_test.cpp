/* log_file_test.cpp: what is written, liblcm reads; what is not finished is not there. */
#include "log_file.hpp"

#include "check.h"

#include <lcm/lcm-cpp.hpp>
#include <sys/stat.h>
#include <unistd.h>

using namespace coptersim_stream;

namespace {

bool exists(const std::string &file) {
    struct stat status;
    return stat(file.c_str(), &status) == 0;
}

void liblcm_reads_it(const std::string &file) {
    std::remove(file.c_str());
    std::string error, bytes("a\0b", 3);
    log_file log;
    CHECK(log.open(file, error));
    CHECK(log.put(5, "FIRST", bytes, error));
    CHECK(log.put(std::uint64_t{1} << 40, "SECOND", "", error));
    CHECK(!exists(file));
    CHECK(log.finish(error));
    lcm::LogFile read(file, "r");
    CHECK(read.good());
    const lcm::LogEvent *event = read.readNextEvent();
    CHECK(event != nullptr && event->eventnum == 0 && event->timestamp == 5 &&
          event->channel == "FIRST" &&
          std::string(static_cast<const char *>(event->data),
                      static_cast<std::size_t>(event->datalen)) == bytes);
    event = read.readNextEvent();
    CHECK(event != nullptr && event->eventnum == 1 && event->timestamp == std::int64_t{1} << 40 &&
          event->channel == "SECOND" && event->datalen == 0);
    CHECK(read.readNextEvent() == nullptr);
}

void unfinished_it_leaves_nothing(const std::string &file) {
    std::remove(file.c_str());
    std::string part = file + ".part." + std::to_string(getpid());
    {
        log_file log;
        std::string error;
        CHECK(log.open(file, error));
        CHECK(log.put(0, "C", "x", error));
        CHECK(exists(part));
    }
    CHECK(!exists(part));
    CHECK(!exists(file));
}

void what_fails_is_one_line() {
    std::string error;
    log_file nowhere;
    CHECK(!nowhere.open("/nowhere/x.lcm", error));
    CHECK(error == "/nowhere/x.lcm: No such file or directory");
    log_file full;
    CHECK(full.open("/dev/full", error));
    full.put(0, "C", "x", error);
    CHECK(!full.finish(error));
    CHECK(error == "/dev/full: No space left on device");
}

} // namespace

int main(int argc, char **argv) {
    CHECK_INT(argc, 2);
    liblcm_reads_it(argv[1]);
    unfinished_it_leaves_nothing(argv[1]);
    what_fails_is_one_line();
    return CHECK_RESULT();
}
