#include "server.hpp"

#include "external_term.hpp"

#include "../core/error.hpp"
#include "../core/names.hpp"
#include "../core/stub.hpp"

#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>

namespace cb {

namespace {

const Name kError{"error"};
const Name kHello{"hello"};
const Name kFork{"fork"};
const Name kEndTest{"end_test"};
const Name kStop{"stop"};
const Name kSymbolise{"symbolise"};
const Name kFlushCoverage{"flush_coverage"};
const Name kChild{"child"};
const Name kExit{"exit"};
const Name kSignal{"signal"};

Server *current_server = nullptr;

} // namespace

Server::Server(int in, int out) : channel_(in, out) {
    void *memory =
        mmap(nullptr, sizeof(Shared), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) {
        throw std::bad_alloc();
    }
    shared_ = new (memory) Shared{false};
    current_server = this;
    set_stub_callback([](const char *name, void **arguments, void *result) {
        Server::current()->ask(name, arguments, result);
    });
}

Server::~Server() {
    munmap(shared_, sizeof *shared_);
    current_server = nullptr;
}

Server *Server::current() {
    return current_server;
}

int Server::run() {
    while (channel_.read(packet_)) {
        reader_.begin(packet_.data(), packet_.size());
        Term parts[2];
        unsigned count = 0;
        if (!reader_.read_tuple(reader_.root(), parts, 2, count) || count != 2) {
            throw MalformedTerm("a message that is not {Id, Request}", 1);
        }
        if (serve(parts[0], parts[1]) == After::End) {
            return kExitOk;
        }
    }
    if (is_child_) {
        end_child();
    }
    return kExitOk;
}

Server::After Server::serve(Term id, Term request) {
    bool taken = false;
    const After after = control(id, request, taken);
    if (!taken) {
        reply(id, request);
    }
    return after;
}

// Requests that are about this process rather than about the library.
Server::After Server::control(Term id, Term request, bool &taken) {
    taken = true;
    if (!greeted_) {
        greeted_ = reader_.is_atom(request, kHello);
        taken = false;
        return After::GoOn;
    }
    if (reader_.is_atom(request, kFork) && !is_child_) {
        fork_child(id);
        return shared_->stop ? After::End : After::GoOn;
    }
    const bool stop = reader_.is_atom(request, kStop);
    if (stop || (is_child_ && reader_.is_atom(request, kEndTest))) {
        shared_->stop = stop;
        if (is_child_ && session_ != nullptr) {
            session_->flush_coverage();
        }
        reply_ok(id);
        if (is_child_) {
            end_child();
        }
        return After::End;
    }
    taken = false;
    return After::GoOn;
}

bool Server::concerns_parent(Term request) {
    Term parts[2];
    unsigned count = 0;
    if (reader_.read_tuple(request, parts, 2, count)) {
        return reader_.is_atom(parts[0], kSymbolise);
    }
    return reader_.is_atom(request, kFlushCoverage);
}

void Server::reply_ok(Term id) {
    writer_.begin();
    writer_.begin_tuple(3);
    writer_.write_term(reader_, id);
    writer_.write_name(names::ok);
    writer_.write_name(names::ok);
    writer_.end();
    channel_.write(writer_.packet());
}

void Server::reply(Term id, Term request) {
    const auto begin = [&](const Name &status) {
        writer_.begin();
        writer_.begin_tuple(3);
        writer_.write_term(reader_, id);
        writer_.write_name(status);
    };
    try {
        if (!greeted_) {
            fail("protocol", Tree::atom("hello_expected"));
        }
        if (has_forked_ && !is_child_ && !concerns_parent(request)) {
            fail("no_child"); // it was meant for a child that has ended; the parent stays as loaded
        }
        begin(names::ok);
        dispatch(session_, reader_, request, writer_);
    } catch (const Error &error) {
        begin(kError);
        error.reason().write(writer_);
    } catch (const std::bad_alloc &) {
        begin(kError);
        writer_.write_atom("no_memory");
    }
    writer_.end();
    channel_.write(writer_.packet());
}

void Server::fork_child(Term id) {
    std::fflush(nullptr); // or both processes would write what is in the buffers
    if (session_ != nullptr) {
        session_->forget_pointers(); // those of the child before are stale in the one after it
    }
    const pid_t parent = getpid();
    const pid_t child = fork();
    has_forked_ = true;
    if (child > 0) {
        channel_.forget_input();
        return await_child(child);
    }
    writer_.begin();
    writer_.begin_tuple(3);
    writer_.write_term(reader_, id);
    if (child == 0) {
        is_child_ = true;
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != parent) {
            _exit(kExitOk);
        }
        if (session_ != nullptr) {
            session_->reset_coverage(); // the parent's counts are the parent's
        }
        writer_.write_name(names::ok);
        writer_.write_signed(getpid());
    } else {
        writer_.write_name(kError);
        Tree::tuple({Tree::atom("fork"), Tree::binary(std::strerror(errno))}).write(writer_);
    }
    writer_.end();
    channel_.write(writer_.packet());
}

void Server::await_child(int child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    const bool signalled = WIFSIGNALED(status);
    writer_.begin();
    writer_.begin_tuple(3);
    writer_.write_signed(0);
    writer_.write_name(kChild);
    writer_.begin_tuple(2);
    writer_.write_name(signalled ? kSignal : kExit);
    writer_.write_signed(signalled ? WTERMSIG(status) : WEXITSTATUS(status));
    writer_.end();
    writer_.end();
    channel_.write(writer_.packet());
}

void Server::end_child() {
    std::fflush(nullptr);
    _exit(kExitOk); // not exit(): what ends the process for good is the parent's
}

} // namespace cb
