// Requests: from a term to what a session does, and the value back.
#pragma once

#include "session.hpp"
#include "term.hpp"

#include <memory>

namespace cb {

constexpr int kProtocol = 1;

// Carries out one request and writes its value. `session` is empty until `load`. Throws Error
// (whatever has been written then is to be thrown away). `fork`, `end_test` and `stop` are the
// front end's.
void dispatch(std::unique_ptr<Session> &session, TermReader &reader, Term request,
              TermWriter &writer);

// The two requests of the hot path, for front ends that have their parts already.
void call(Session &session, TermReader &reader, Term function, Term arguments, TermWriter &writer);
void call_batch(Session &session, TermReader &reader, Term calls, TermWriter &writer);

Session &loaded(std::unique_ptr<Session> &session);

} // namespace cb
