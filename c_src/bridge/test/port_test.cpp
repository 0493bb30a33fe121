// The port program from outside: port_test PROGRAM LIBRARY LOG
#include "check.h"
#include "child.hpp"

#include "../port/ei_terms.hpp"
#include "text_terms.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <string>

using namespace cb;

namespace {

std::string program;
std::string library;
std::string log_file;

bool contains(const std::string &text, const std::string &part) {
    return text.find(part) != std::string::npos;
}

// Writes a term read by one reader to a writer of another kind.
void copy(TermReader &reader, Term term, TermWriter &writer) {
    std::int64_t integer = 0;
    std::uint64_t wide = 0;
    double number = 0;
    std::string_view text;
    ListCursor cursor;
    MapEntries entries;
    Term parts[8];
    unsigned count = 0;
    if (reader.read_signed(term, integer)) {
        writer.write_signed(integer);
    } else if (reader.read_unsigned(term, wide)) {
        writer.write_unsigned(wide);
    } else if (reader.read_float(term, number)) {
        writer.write_float(number);
    } else if (reader.read_atom(term, text)) {
        writer.write_atom(text);
    } else if (reader.read_binary(term, text)) {
        writer.write_binary(text);
    } else if (reader.read_tuple(term, parts, 8, count)) {
        writer.begin_tuple(count);
        for (unsigned i = 0; i < count; ++i) {
            copy(reader, parts[i], writer);
        }
        writer.end();
    } else if (reader.read_list(term, cursor)) {
        writer.begin_list(cursor.left);
        while (cursor.left > 0) {
            copy(reader, reader.next(cursor), writer);
        }
        writer.end();
    } else if (reader.read_map(term, entries)) {
        writer.begin_map(static_cast<unsigned>(entries.size()));
        for (const auto &[key, value] : entries) {
            copy(reader, key, writer);
            copy(reader, value, writer);
        }
        writer.end();
    } else {
        writer.write_atom("?");
    }
}

std::string packet(const std::string &text) {
    TextReader reader;
    EiWriter writer;
    copy(reader, reader.parse(text), writer);
    return std::string(writer.packet());
}

std::string next_message(Child &port) {
    const std::string header = port.read(4);
    if (header.size() < 4) {
        return "end";
    }
    std::uint32_t length = 0;
    for (const char c : header) {
        length = length << 8 | static_cast<unsigned char>(c);
    }
    const std::string body = port.read(length);
    EiReader reader;
    reader.begin(body.data(), body.size());
    TextWriter writer;
    copy(reader, reader.root(), writer);
    return writer.text();
}

std::string ask(Child &port, const std::string &request) {
    port.write(packet("{1," + request + "}"));
    return next_message(port);
}

// A port that has loaded the library, with a fresh log.
Child start_raw() {
    unlink(log_file.c_str());
    return Child({program, log_file});
}

void load(Child &port) {
    CHECK(contains(ask(port, "hello"), "protocol=>1"));
    CHECK(contains(ask(port, "{load,<<\"" + library + "\">>,#{}}"), "{1,ok,#{file=>"));
}

void it_serves_until_the_end_of_input_or_stop() {
    Child port = start_raw();
    CHECK(ask(port, "{call,count,[]}") == "{1,error,{protocol,hello_expected}}");
    load(port);
    CHECK(ask(port, "{call,count,[]}") == "{1,ok,1}");
    CHECK(ask(port, "{call,cuont,[]}") == "{1,error,{unknown_function,cuont,[count]}}");
    CHECK(ask(port, "{batch,[{count,[]},{count,[x]}]}") ==
          "{1,error,{batch,2,[2],{arity,count,0,1,<<\"int count(void)\">>}}}");
    port.close_input();
    CHECK(port.wait() == 0);
    Child other = start_raw();
    CHECK(contains(ask(other, "hello"), "{1,ok,"));
    CHECK(ask(other, "stop") == "{1,ok,ok}");
    CHECK(other.wait() == 0);
}

void the_library_prints_into_the_log() {
    Child port = start_raw();
    load(port);
    CHECK(ask(port, "{call,say,[<<\"from the library\">>]}") == "{1,ok,ok}");
    CHECK(file_text(log_file) == "from the library\n");
}

void malformed_messages_end_it_with_a_line() {
    const std::string good = packet("{1,{call,count,[]}}");
    const std::string cases[] = {
        std::string("\0\0\0\0", 4),                           // nothing
        std::string("\0\0\0\1\x83", 5),                       // a version byte alone
        std::string("\0\0\0\2\x82\x6a", 6),                   // another version
        std::string("\0\0\0\2\x83\x6a", 6),                   // [] is no request
        std::string("\0\0\0\3\x83\x6a\x6a", 7),               // something behind the term
        std::string("\0\0\0\7\x83l\xff\xff\xff\xff\x6a", 11), // a list of 4 thousand million
        std::string("\xff\xff\xff\xff", 4),                   // an impossible length
        good.substr(0, good.size() - 1),                      // cut off
        good.substr(0, 2),
    };
    for (const std::string &bytes : cases) {
        Child port = start_raw();
        port.write(bytes);
        port.close_input();
        CHECK(port.wait() == 3);
        const std::string log = file_text(log_file);
        CHECK(log.rfind("c_bridge_port: malformed message: ", 0) == 0);
        CHECK(log.find('\n') == log.size() - 1);
    }
}

void a_wrong_command_line_is_refused() {
    Child nothing({program});
    CHECK(nothing.wait() == 2);
    Child elsewhere({program, "/no/such/folder/log"});
    CHECK(elsewhere.wait() == 2);
}

struct Crash {
    const char *call;
    int status;
    const char *line;
};

void crashes_leave_frames_in_the_log() {
    const Crash crashes[] = {
        {"{call,read_through,[null]}", 128 + SIGSEGV,
         "@c_bridge signal 11 SIGSEGV code 1 addr 0x0 pc 0x"},
        {"{call,jump_to_nothing,[]}", 128 + SIGSEGV,
         "@c_bridge signal 11 SIGSEGV code 1 addr 0x0 pc 0x0\n"},
        {"{call,divide,[1,0]}", 128 + SIGFPE, "@c_bridge signal 8 SIGFPE code 1 addr 0x"},
        {"{call,give_up,[]}", 128 + SIGABRT, "@c_bridge signal 6 SIGABRT code "},
        {"{call,recurse,[100000000]}", 128 + SIGSEGV, "@c_bridge skipped "},
    };
    for (const Crash &crash : crashes) {
        Child port = start_raw();
        load(port);
        CHECK(ask(port, crash.call) == "end");
        CHECK(port.wait() == crash.status);
        const std::string log = file_text(log_file);
        CHECK(contains(log, crash.line));
        CHECK(contains(log, "@c_bridge frame " + library + " 0x"));
    }
}

void a_hang_shows_its_place_on_sigquit() {
    Child port = start_raw();
    load(port);
    port.write(packet("{1,{call,wait_forever,[]}}"));
    // The library's own counter cannot be seen from here, so any place of the call will do.
    kill(port.pid(), SIGQUIT);
    CHECK(port.wait() == 128 + SIGQUIT);
    CHECK(contains(file_text(log_file), "@c_bridge signal 3 SIGQUIT"));
}

void a_forked_child_serves_one_test() {
    Child port = start_raw();
    load(port);
    CHECK(ask(port, "end_test") == "{1,error,{bad_request,end_test}}");
    CHECK(ask(port, "{call,count,[]}") == "{1,ok,1}");
    CHECK(contains(ask(port, "fork"), "{1,ok,"));
    CHECK(ask(port, "{call,count,[]}") == "{1,ok,2}");
    CHECK(ask(port, "end_test") == "{1,ok,ok}");
    CHECK(next_message(port) == "{0,child,{exit,0}}");
    CHECK(contains(ask(port, "fork"), "{1,ok,"));
    CHECK(ask(port, "{call,read_through,[null]}") == "{0,child,{signal,11}}");
    CHECK(contains(ask(port, "fork"), "{1,ok,"));
    CHECK(ask(port, "{call,leave,[7]}") == "{0,child,{exit,7}}");
    CHECK(ask(port, "{call,count,[]}") == "{1,error,no_child}"); // the parent stays as loaded
    CHECK(contains(ask(port, "fork"), "{1,ok,"));
    CHECK(ask(port, "stop") == "{1,ok,ok}");
    CHECK(next_message(port) == "{0,child,{exit,0}}");
    CHECK(port.wait() == 0);
}

int child_pid(const std::string &reply) {
    return std::atoi(reply.c_str() + std::strlen("{1,ok,"));
}

void nothing_outlives_the_program_that_started_it() {
    Child port = start_raw();
    load(port);
    const int child = child_pid(ask(port, "fork"));
    CHECK(child > 0);
    port.write(packet("{1,{call,wait_forever,[]}}"));
    kill(port.pid(), SIGKILL);
    CHECK(port.wait() == 128 + SIGKILL);
    await_death(child);
    CHECK(is_dead(child));
}

void stale_pointers_of_a_child_are_known() {
    Child port = start_raw();
    load(port);
    ask(port, "fork");
    const std::string reply = ask(port, "{address_of,[calls]}");
    const std::string pointer = reply.substr(6, reply.size() - 7);
    CHECK(ask(port, "{read," + pointer + ",1}") == "{1,ok,[0]}");
    ask(port, "end_test");
    next_message(port);
    ask(port, "fork");
    CHECK(ask(port, "{read," + pointer + ",1}") == "{1,error,{stale_pointer," + pointer + "}}");
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 4) {
        return 2;
    }
    alarm(60); // ends a test that waits in vain
    signal(SIGPIPE, SIG_IGN);
    program = argv[1];
    library = argv[2];
    log_file = argv[3];
    it_serves_until_the_end_of_input_or_stop();
    the_library_prints_into_the_log();
    malformed_messages_end_it_with_a_line();
    a_wrong_command_line_is_refused();
    crashes_leave_frames_in_the_log();
    a_hang_shows_its_place_on_sigquit();
    a_forked_child_serves_one_test();
    nothing_outlives_the_program_that_started_it();
    stale_pointers_of_a_child_are_known();
    return check_failures != 0;
}
