// c_bridge_port LOG: calls the functions of one library on behalf of a virtual machine (see
// server.hpp).
#include "crash_log.hpp"
#include "external_term.hpp"
#include "server.hpp"

#include <ei.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

constexpr int kFirstOwnFd = 10;

int move_away(int fd) {
    return fcntl(fd, F_DUPFD_CLOEXEC, kFirstOwnFd);
}

bool replace(int fd, const char *file, int flags) {
    const int opened = open(file, flags | O_CLOEXEC, 0666);
    const bool done = opened >= 0 && dup2(opened, fd) >= 0;
    if (opened >= 0) {
        close(opened);
    }
    return done;
}

// What the library prints must not get between the packets, nor be lost when it crashes.
bool separate_output(const char *log) {
    if (!replace(STDERR_FILENO, log, O_WRONLY | O_CREAT | O_APPEND) ||
        dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
        return false;
    }
    std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
    return replace(STDIN_FILENO, "/dev/null", O_RDONLY);
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: c_bridge_port LOG (packets on standard input and output)\n");
        return cb::kExitUsage;
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int in = move_away(STDIN_FILENO);
    const int out = move_away(STDOUT_FILENO);
    if (in < 0 || out < 0 || !separate_output(argv[1])) {
        std::fprintf(stderr, "c_bridge_port: cannot open %s: %s\n", argv[1], std::strerror(errno));
        return cb::kExitUsage;
    }
    cb::install_crash_handlers();
    ei_init();
    try {
        cb::Server server(in, out);
        return server.run();
    } catch (const cb::MalformedTerm &error) {
        std::fprintf(stderr, "c_bridge_port: malformed message: %s\n", error.what());
    } catch (const cb::BrokenChannel &error) {
        std::fprintf(stderr, "c_bridge_port: malformed message: %s\n", error.what());
    }
    return cb::kExitMalformed;
}
