// The guard program: guard_test PROGRAM LOG
#include "check.h"
#include "child.hpp"

#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

using cb::Child;

namespace {

std::string program;
std::string log_file;

Child guarded(const std::string &script) {
    unlink(log_file.c_str());
    return Child({program, log_file, "/bin/sh", "-c", script});
}

void the_status_is_that_of_the_program() {
    Child good = guarded("exit 0");
    CHECK(good.wait() == 0);
    Child bad = guarded("exit 17");
    CHECK(bad.wait() == 17);
    Child killed = guarded("kill -SEGV $$");
    CHECK(killed.wait() == 128 + SIGSEGV);
}

void output_goes_to_the_log_and_input_is_empty() {
    Child child = guarded("echo out; echo err >&2; cat");
    CHECK(child.wait() == 0);
    CHECK(cb::file_text(log_file) == "out\nerr\n");
    Child open({program, "-", "/bin/sh", "-c", "echo seen"});
    CHECK(open.read(5) == "seen\n");
    CHECK(open.wait() == 0);
}

// The program tells the id of a grandchild that ignores hangups and outlives its parent.
void the_whole_group_ends_with_the_guard(int signal_to_guard) {
    Child child({program, "-", "/bin/sh", "-c", "trap '' HUP TERM; sleep 1000 & echo $!; wait"});
    std::string line;
    for (std::string c = child.read(1); !c.empty() && c != "\n"; c = child.read(1)) {
        line += c;
    }
    const pid_t grandchild = std::atoi(line.c_str());
    CHECK(grandchild > 0);
    kill(child.pid(), signal_to_guard);
    CHECK(child.wait() == 128 + SIGKILL);
    cb::await_death(grandchild);
    CHECK(cb::is_dead(grandchild));
}

void what_the_program_leaves_behind_is_ended_too() {
    Child child({program, "-", "/bin/sh", "-c", "sleep 1000 >/dev/null & echo $!"});
    const pid_t left = std::atoi(child.read(16).c_str());
    CHECK(child.wait() == 0);
    cb::await_death(left);
    CHECK(left > 0 && cb::is_dead(left));
}

void wrong_usage_is_refused() {
    Child nothing({program});
    CHECK(nothing.wait() == 2);
    Child missing({program, "-", "/no/such/program"});
    CHECK(missing.wait() == 127);
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 3) {
        return 2;
    }
    alarm(60); // ends a test that waits in vain
    program = argv[1];
    log_file = argv[2];
    the_status_is_that_of_the_program();
    output_goes_to_the_log_and_input_is_empty();
    the_whole_group_ends_with_the_guard(SIGTERM);
    the_whole_group_ends_with_the_guard(SIGINT);
    what_the_program_leaves_behind_is_ended_too();
    wrong_usage_is_refused();
    return check_failures != 0;
}
