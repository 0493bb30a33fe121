// Journals: journal_test FILE
#include "check.h"
#include "child.hpp"

#include "../nif/journal.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <string>
#include <system_error>

using cb::Journal;

namespace {

std::string file;

// What a reader sees: the records up to the published end, each in brackets.
std::string records() {
    const std::string bytes = cb::file_text(file);
    if (bytes.compare(0, 8, "FCJRNL1\n") != 0) {
        return "not a journal";
    }
    std::uint64_t end = 0;
    std::memcpy(&end, bytes.data() + 8, sizeof end);
    std::string text;
    for (std::size_t at = 16; at < end;) {
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + at, sizeof length);
        text += "[" + bytes.substr(at + 4, length) + "]";
        at += 4 + length;
    }
    return text;
}

bool append(Journal &journal, const std::string &record) {
    return journal.append(record.data(), record.size());
}

void records_are_visible_at_once() {
    Journal journal(file, 64);
    CHECK(records().empty());
    CHECK(append(journal, "one"));
    CHECK(append(journal, ""));
    CHECK(append(journal, "three"));
    CHECK(records() == "[one][][three]");
    CHECK(journal.start("head", 4));
    CHECK(records() == "[head]");
}

void a_record_that_does_not_fit_changes_nothing() {
    Journal journal(file, 16 + 4 + 3);
    CHECK(!append(journal, "four"));
    CHECK(append(journal, "two"));
    CHECK(!append(journal, ""));
    CHECK(records() == "[two]");
    Journal none(file, 0);
    CHECK(!append(none, ""));
}

void what_was_written_survives_the_writer() {
    const pid_t writer = fork();
    if (writer == 0) {
        Journal journal(file, 4096);
        append(journal, "before the end");
        abort();
    }
    waitpid(writer, nullptr, 0);
    CHECK(records() == "[before the end]");
}

void files_that_cannot_be_made_are_reported() {
    bool failed = false;
    try {
        Journal journal("/no/such/folder/journal", 100);
    } catch (const std::system_error &error) {
        failed = error.code().value() == ENOENT;
    }
    CHECK(failed);
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        return 2;
    }
    file = argv[1];
    records_are_visible_at_once();
    a_record_that_does_not_fit_changes_nothing();
    what_was_written_survives_the_writer();
    files_that_cannot_be_made_are_reported();
    return check_failures != 0;
}
