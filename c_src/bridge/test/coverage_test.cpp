// Coverage counters survive resets: coverage_test DIRECTORY with counted.so, counted.gcno
#include "check.h"
#include "talk.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <string>

using cb::Talk;

namespace {

std::string directory;

// How often gcov says that the line with the increment ran.
int counted() {
    const std::string command = "cd '" + directory + "' && gcov -t counted.gcda 2>&1";
    FILE *gcov = popen(command.c_str(), "r");
    char line[256];
    int count = -1;
    while (fgets(line, sizeof line, gcov) != nullptr) {
        if (std::string(line).find("return ++state") != std::string::npos) {
            count = std::atoi(line);
        }
    }
    pclose(gcov);
    return count;
}

void start_afresh() {
    unlink((directory + "/counted.gcda").c_str());
}

void counts_survive_a_restore() {
    start_afresh();
    Talk talk(directory + "/counted.so");
    IS(talk, "snapshot", "ok");
    IS(talk, "{batch,[{counted_call,[]},{counted_call,[]},{counted_call,[]}]}", "[1,2,3]");
    IS(talk, "restore", "ok");
    IS(talk, "{batch,[{counted_call,[]},{counted_call,[]}]}", "[1,2]");
    IS(talk, "flush_coverage", "1");
    CHECK(counted() == 5);
    IS(talk, "{call,counted_call,[]}", "3");
    IS(talk, "flush_coverage", "1");
    CHECK(counted() == 6);
}

void counts_survive_a_reload() {
    start_afresh();
    Talk talk(directory + "/counted.so");
    IS(talk, "{batch,[{counted_call,[]},{counted_call,[]}]}", "[1,2]");
    IS(talk, "reload", "ok");
    IS(talk, "{call,counted_call,[]}", "1");
    talk.end();
    CHECK(counted() == 3);
}

void instrumentation_does_not_count_as_a_constructor() {
    Talk talk;
    const std::string reply = talk("{load,<<\"" + directory + "/counted.so\">>,#{}}");
    CHECK(reply.find("perhaps only its coverage counters do") != std::string::npos);
    CHECK(reply.find("constructors") == std::string::npos);
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        return 2;
    }
    directory = argv[1];
    counts_survive_a_restore();
    counts_survive_a_reload();
    instrumentation_does_not_count_as_a_constructor();
    return check_failures != 0;
}
