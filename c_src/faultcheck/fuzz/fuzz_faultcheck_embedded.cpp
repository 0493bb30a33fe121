// Any bytes as command lines of the embedded profile, with probe calls in between.
//
// Each command gives one answer, ok or error, at its end; an error changes nothing; what is off, or
// has no fault, stays as it is.
#include "fi.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

namespace {

void require(bool condition) {
    if (!condition)
        std::abort();
}

constexpr int kLines = 16; // enough for each limit to be met, few enough for many runs

std::string replies; // each with a line feed
std::string last;    // without

void keep(const char *line) {
    const std::size_t length = std::strlen(line);
    require(length < FI_ID_BYTES + 100 && std::memchr(line, '\n', length) == nullptr);
    require(last.empty() || last.compare(0, 6, "probe=") == 0); // the answer is the last
    last.assign(line, length);
    replies.append(line, length).push_back('\n');
}

const std::string &run(const char *line) {
    replies.clear();
    last.clear();
    fi_process_line(line, keep);
    require(last == "ok" || last.compare(0, 7, "error: ") == 0);
    return replies;
}

void command(const std::string &line) {
    const std::string before = run("fi_print_faults");
    const bool active = fi_is_active();
    run(line.c_str());
    if (last != "ok") {
        require(fi_is_active() == active);
        require(run("fi_print_faults") == before);
    }
}

// The identifier of the line, if it is one that adds a fault, and one that none has.
void probe(const std::string &line) {
    const std::size_t begin =
        line.find_first_not_of(' ', std::min(line.size(), std::strlen("fi_add_fault")));
    const std::string id =
        begin == std::string::npos ? "" : line.substr(begin, line.find(' ', begin) - begin);
    int whole = 1000;
    float real = 1.5f;
    fi_inject_fault_int(id.c_str(), &whole);
    fi_inject_fault_float(id.c_str(), &real);
    require(fi_is_active() || (whole == 1000 && real == 1.5f));
    whole = 7;
    fi_inject_fault_int("no such", &whole); // has a space, so no command can name it
    require(whole == 7);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    fi_init();
    require(run("fi_print_faults") == "ok\n");
    const std::string text(reinterpret_cast<const char *>(data), size);
    std::size_t begin = 0;
    for (int lines = 0; lines < kLines && begin < text.size(); ++lines) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        command(line);
        probe(line);
        begin = end + 1;
    }
    return 0;
}
