// The port program's loop: one request, one reply; a fork of itself serves one test.
//
//   in   {Id, Request}          out  {Id, ok, Value} | {Id, error, Reason}
//                                    {0, child, {exit, N} | {signal, N}}     at the end of a forked
//                                    child {0, callback, Name, Args}               a stub asks; in:
//                                    {callback, Value}
#pragma once

#include "channel.hpp"
#include "ei_terms.hpp"

#include "../core/dispatch.hpp"

#include <memory>
#include <vector>

namespace cb {

enum ExitStatus { kExitOk = 0, kExitUsage = 2, kExitMalformed = 3 };

class Server {
  public:
    Server(int in, int out);
    ~Server();
    // Serves until `stop` or the end of input. Throws MalformedTerm and BrokenChannel.
    int run();
    // Asks Erlang on behalf of a stub, see stub.hpp. Throws Error.
    void ask(const char *name, void **arguments, void *result);
    // The server of this process.
    static Server *current();

  private:
    enum class After { GoOn, End };
    // What parent and forked child both see.
    struct Shared {
        bool stop; // the child was asked to stop: the parent stops too
    };

    After serve(Term id, Term request);
    After control(Term id, Term request, bool &taken);
    bool concerns_parent(Term request);
    void reply_ok(Term id);
    void reply(Term id, Term request);
    void fork_child(Term id);
    void await_child(int child);
    [[noreturn]] void end_child();
    Term next_answer(std::vector<char> &packet, EiReader &reader);
    void read_answer(const char *name, const Type &type, void *result);

    Channel channel_;
    EiReader reader_;
    EiWriter writer_;
    std::vector<char> packet_;
    std::unique_ptr<Session> session_;
    Shared *shared_;
    bool greeted_ = false;
    bool is_child_ = false;
    bool has_forked_ = false;
};

} // namespace cb
