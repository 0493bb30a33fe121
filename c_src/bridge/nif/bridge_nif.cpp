// Native functions of cb_nif: sessions, journals, and two calls of the operating system. Errors are
// values here; a term that is no session or journal is badarg.
#include "journal.hpp"
#include "nif_terms.hpp"

#include "../core/dispatch.hpp"
#include "../core/error.hpp"
#include "../core/names.hpp"

#include <signal.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <system_error>

namespace cb {

namespace {

struct NifSession {
    std::atomic<bool> busy{false}; // one request at a time, from whichever scheduler
    std::unique_ptr<Session> session;
    NifReader reader;
    NifWriter writer;
};

class Occupied {
  public:
    explicit Occupied(std::atomic<bool> &flag)
        : flag_(flag), mine_(!flag.exchange(true, std::memory_order_acquire)) {}
    ~Occupied() {
        if (mine_) {
            flag_.store(false, std::memory_order_release);
        }
    }
    Occupied(const Occupied &) = delete;
    Occupied &operator=(const Occupied &) = delete;
    explicit operator bool() const {
        return mine_;
    }

  private:
    std::atomic<bool> &flag_;
    bool mine_;
};

ErlNifResourceType *session_type = nullptr;
ErlNifResourceType *journal_type = nullptr;

const Name kError{"error"};
const Name kFull{"full"};
const Name kStop{"stop"};

template <typename T> void destroy(ErlNifEnv *, void *object) {
    static_cast<T *>(object)->~T();
}

NifSession *session_of(ErlNifEnv *env, ERL_NIF_TERM term) {
    void *object = nullptr;
    return enif_get_resource(env, term, session_type, &object) != 0
               ? static_cast<NifSession *>(object)
               : nullptr;
}

ERL_NIF_TERM error_tuple(ErlNifEnv *env, ERL_NIF_TERM reason) {
    return enif_make_tuple2(env, atom_of(env, kError), reason);
}

ERL_NIF_TERM error_reason(ErlNifEnv *env, NifWriter &writer, const Tree &reason) {
    writer.begin(env);
    reason.write(writer);
    return error_tuple(env, writer.result());
}

// Runs `work` with the session's reader and writer and answers {ok, what it wrote} or {error,
// Reason}.
template <typename Work> ERL_NIF_TERM answer(ErlNifEnv *env, ERL_NIF_TERM term, Work work) {
    NifSession *session = session_of(env, term);
    if (session == nullptr) {
        return enif_make_badarg(env);
    }
    // Waiting would hold up a scheduler for as long as the other call takes.
    const Occupied occupied(session->busy);
    if (!occupied) {
        return error_tuple(env, enif_make_atom(env, "busy"));
    }
    session->reader.begin(env);
    session->writer.begin(env);
    try {
        work(*session);
        return enif_make_tuple2(env, atom_of(env, names::ok), session->writer.result());
    } catch (const Error &error) {
        return error_reason(env, session->writer, error.reason());
    } catch (const std::bad_alloc &) {
        return error_reason(env, session->writer, Tree::atom("no_memory"));
    }
}

ERL_NIF_TERM new_session(ErlNifEnv *env, int, const ERL_NIF_TERM[]) {
    void *memory = enif_alloc_resource(session_type, sizeof(NifSession));
    auto *session = new (memory) NifSession();
    const ERL_NIF_TERM term = enif_make_resource(env, session);
    enif_release_resource(session);
    return term;
}

ERL_NIF_TERM request(ErlNifEnv *env, int, const ERL_NIF_TERM argv[]) {
    return answer(env, argv[0], [&](NifSession &s) {
        if (s.reader.is_atom(argv[1], kStop)) {
            s.session.reset();
            s.writer.write_name(names::ok);
        } else {
            dispatch(s.session, s.reader, argv[1], s.writer);
        }
    });
}

ERL_NIF_TERM call_function(ErlNifEnv *env, int, const ERL_NIF_TERM argv[]) {
    return answer(env, argv[0], [&](NifSession &s) {
        call(loaded(s.session), s.reader, argv[1], argv[2], s.writer);
    });
}

ERL_NIF_TERM batch(ErlNifEnv *env, int, const ERL_NIF_TERM argv[]) {
    return answer(env, argv[0], [&](NifSession &s) {
        call_batch(loaded(s.session), s.reader, argv[1], s.writer);
    });
}

// Text as unicode:chardata(), in UTF-8 if it is a binary.
bool text_argument(ErlNifEnv *env, ERL_NIF_TERM term, std::string &out) {
    NifReader reader;
    reader.begin(env);
    ErlNifBinary bytes;
    if (enif_inspect_iolist_as_binary(env, term, &bytes) != 0) {
        out.assign(reinterpret_cast<const char *>(bytes.data), bytes.size);
        return out.find('\0') == std::string::npos;
    }
    return read_text(reader, term, out);
}

ERL_NIF_TERM posix_error(ErlNifEnv *env, int code) {
    const char *name = strerrorname_np(code);
    std::string text = name != nullptr ? name : std::to_string(code);
    for (char &c : text) {
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    }
    return error_tuple(env, enif_make_atom(env, text.c_str()));
}

ERL_NIF_TERM journal_open(ErlNifEnv *env, int, const ERL_NIF_TERM argv[]) {
    std::string file;
    ErlNifUInt64 bytes = 0;
    if (!text_argument(env, argv[0], file) || enif_get_uint64(env, argv[1], &bytes) == 0) {
        return enif_make_badarg(env);
    }
    void *memory = enif_alloc_resource(journal_type, sizeof(std::unique_ptr<Journal>));
    auto *journal = new (memory) std::unique_ptr<Journal>();
    const ERL_NIF_TERM term = enif_make_resource(env, journal);
    enif_release_resource(journal);
    try {
        *journal = std::make_unique<Journal>(file, bytes);
    } catch (const std::system_error &error) {
        return posix_error(env, error.code().value());
    }
    return enif_make_tuple2(env, atom_of(env, names::ok), term);
}

ERL_NIF_TERM journal_write(ErlNifEnv *env, const ERL_NIF_TERM argv[],
                           bool (Journal::*write)(const void *, std::size_t)) {
    void *object = nullptr;
    ErlNifBinary record;
    if (enif_get_resource(env, argv[0], journal_type, &object) == 0 ||
        enif_inspect_iolist_as_binary(env, argv[1], &record) == 0) {
        return enif_make_badarg(env);
    }
    Journal &journal = **static_cast<std::unique_ptr<Journal> *>(object);
    return (journal.*write)(record.data, record.size) ? atom_of(env, names::ok)
                                                      : error_tuple(env, atom_of(env, kFull));
}

ERL_NIF_TERM journal_start(ErlNifEnv *env, int, const ERL_NIF_TERM argv[]) {
    return journal_write(env, argv, &Journal::start);
}

ERL_NIF_TERM journal_append(ErlNifEnv *env, int, const ERL_NIF_TERM argv[]) {
    return journal_write(env, argv, &Journal::append);
}

ERL_NIF_TERM send_signal(ErlNifEnv *env, int, const ERL_NIF_TERM argv[]) {
    int pid = 0;
    int number = 0;
    if (enif_get_int(env, argv[0], &pid) == 0 || pid <= 0 ||
        enif_get_int(env, argv[1], &number) == 0 || number < 0) {
        return enif_make_badarg(env);
    }
    return kill(pid, number) == 0 ? atom_of(env, names::ok) : posix_error(env, errno);
}

ERL_NIF_TERM set_environment(ErlNifEnv *env, int, const ERL_NIF_TERM argv[]) {
    std::string name;
    std::string value;
    if (!text_argument(env, argv[0], name) || !text_argument(env, argv[1], value) ||
        setenv(name.c_str(), value.c_str(), 1) != 0) {
        return enif_make_badarg(env);
    }
    return atom_of(env, names::ok);
}

// Erlang has no way to hear of SIGINT: it opens the break menu of the VM, or ends it. SIGTERM it
// hears.
void end_politely(int) {
    kill(getpid(), SIGTERM);
}

ERL_NIF_TERM interrupt_as_term(ErlNifEnv *env, int, const ERL_NIF_TERM[]) {
    struct sigaction action = {};
    action.sa_handler = end_politely;
    action.sa_flags = SA_RESTART;
    return sigaction(SIGINT, &action, nullptr) == 0 ? atom_of(env, names::ok)
                                                    : posix_error(env, errno);
}

int open_types(ErlNifEnv *env, ErlNifResourceFlags flags) {
    session_type = enif_open_resource_type(env, nullptr, "c_bridge_session", destroy<NifSession>,
                                           flags, nullptr);
    journal_type = enif_open_resource_type(env, nullptr, "c_bridge_journal",
                                           destroy<std::unique_ptr<Journal>>, flags, nullptr);
    return session_type != nullptr && journal_type != nullptr ? 0 : 1;
}

int load(ErlNifEnv *env, void **, ERL_NIF_TERM) {
    return open_types(env, ERL_NIF_RT_CREATE);
}

int upgrade(ErlNifEnv *env, void **, void **, ERL_NIF_TERM) {
    return open_types(env,
                      static_cast<ErlNifResourceFlags>(ERL_NIF_RT_CREATE | ERL_NIF_RT_TAKEOVER));
}

ErlNifFunc functions[] = {
    {"new", 0, new_session, 0},
    {"request", 2, request, 0},
    {"request_dirty", 2, request, ERL_NIF_DIRTY_JOB_CPU_BOUND},
    {"call", 3, call_function, 0},
    {"call_dirty", 3, call_function, ERL_NIF_DIRTY_JOB_CPU_BOUND},
    {"batch", 2, batch, 0},
    {"journal_open", 2, journal_open, ERL_NIF_DIRTY_JOB_IO_BOUND},
    {"journal_start", 2, journal_start, 0},
    {"journal_append", 2, journal_append, 0},
    {"kill", 2, send_signal, 0},
    {"setenv", 2, set_environment, 0},
    {"interrupt_as_term", 0, interrupt_as_term, 0},
};

} // namespace

} // namespace cb

ERL_NIF_INIT(cb_nif, cb::functions, cb::load, nullptr, cb::upgrade, nullptr)
