#include "dispatch.hpp"

#include "error.hpp"
#include "names.hpp"

#include <unistd.h>

#include <functional>

namespace cb {

namespace {

constexpr unsigned kMostParts = 4;

struct Request {
    std::unique_ptr<Session> &session;
    TermReader &reader;
    Term whole;
    Term part[kMostParts];
    TermWriter &writer;
};

[[noreturn]] void bad_request(const Request &request) {
    fail("bad_request", Tree::foreign(request.reader, request.whole));
}

std::string text_of(Request &request, Term term) {
    std::string text;
    if (!read_text(request.reader, term, text)) {
        bad_request(request);
    }
    return text;
}

std::uint64_t count_of(Request &request, Term term) {
    std::uint64_t count = 0;
    if (!request.reader.read_unsigned(term, count)) {
        bad_request(request);
    }
    return count;
}

void done(Request &request) {
    request.writer.write_name(names::ok);
}

void hello(Request &request) {
    Tree::map({Tree::atom("protocol"), Tree::integer(kProtocol), Tree::atom("version"),
               Tree::binary(FC_VERSION), Tree::atom("pid"), Tree::integer(getpid())})
        .write(request.writer);
}

LoadOptions load_options(Request &request, Term term) {
    LoadOptions options;
    MapEntries entries;
    if (!request.reader.read_map(term, entries)) {
        bad_request(request);
    }
    for (const auto &[key, value] : entries) {
        const std::string name = text_of(request, key);
        ListCursor cursor;
        if (name == "signatures") {
            options.signatures = text_of(request, value);
        } else if (name == "generation") {
            options.generation = count_of(request, value);
        } else if (name == "no_index" && request.reader.read_list(value, cursor)) {
            while (cursor.left > 0) {
                options.no_index.push_back(text_of(request, request.reader.next(cursor)));
            }
        } else {
            bad_request(request);
        }
    }
    return options;
}

void load(Request &request) {
    if (request.session != nullptr) {
        fail("already_loaded");
    }
    request.session = std::make_unique<Session>(text_of(request, request.part[1]),
                                                load_options(request, request.part[2]));
    request.session->description().write(request.writer);
}

void resolve(Request &request) {
    const std::string name = text_of(request, request.part[1]);
    request.writer.write_unsigned(loaded(request.session).resolve(name));
}

void symbolise_request(Request &request) {
    std::vector<Frame> frames;
    ListCursor cursor;
    if (!request.reader.read_list(request.part[1], cursor)) {
        bad_request(request);
    }
    while (cursor.left > 0) {
        Term parts[3];
        unsigned count = 0;
        if (!request.reader.read_tuple(request.reader.next(cursor), parts, 3, count) ||
            count != 3) {
            bad_request(request);
        }
        frames.push_back(Frame{text_of(request, parts[0]), count_of(request, parts[1]),
                               request.reader.is_atom(parts[2], names::true_)});
    }
    symbolise(frames).write(request.writer);
}

struct Operation {
    Name name;
    unsigned size; // of the request's tuple; 1: the atom alone
    void (*run)(Request &);
};

const Operation kOperations[] = {
    {"call", 3,
     [](Request &r) { call(loaded(r.session), r.reader, r.part[1], r.part[2], r.writer); }},
    {"batch", 2, [](Request &r) { call_batch(loaded(r.session), r.reader, r.part[1], r.writer); }},
    {"begin_test", 2,
     [](Request &r) {
         loaded(r.session).forget_pointers();
         call_batch(loaded(r.session), r.reader, r.part[1], r.writer);
     }},
    {"get", 2, [](Request &r) { loaded(r.session).get(r.reader, r.part[1], r.writer); }},
    {"set", 3,
     [](Request &r) {
         loaded(r.session).set(r.reader, r.part[1], r.part[2]);
         done(r);
     }},
    {"restore", 1,
     [](Request &r) {
         loaded(r.session).restore();
         done(r);
     }},
    {"alloc", 3,
     [](Request &r) { loaded(r.session).allocate(r.reader, r.part[1], r.part[2], r.writer); }},
    {"free", 2,
     [](Request &r) {
         loaded(r.session).free(r.reader, r.part[1]);
         done(r);
     }},
    {"read", 3,
     [](Request &r) {
         loaded(r.session).read(r.reader, r.part[1], count_of(r, r.part[2]), r.writer);
     }},
    {"read_bytes", 3,
     [](Request &r) {
         loaded(r.session).read_bytes(r.reader, r.part[1], count_of(r, r.part[2]), r.writer);
     }},
    {"cstring", 2, [](Request &r) { loaded(r.session).cstring(r.reader, r.part[1], r.writer); }},
    {"address_of", 2,
     [](Request &r) { loaded(r.session).address_of(r.reader, r.part[1], r.writer); }},
    {"resolve", 2, resolve},
    {"load", 3, load},
    {"hello", 1, hello},
    {"functions", 1, [](Request &r) { loaded(r.session).functions().write(r.writer); }},
    {"globals", 1, [](Request &r) { loaded(r.session).globals().write(r.writer); }},
    {"snapshot", 1,
     [](Request &r) {
         loaded(r.session).take_snapshot();
         done(r);
     }},
    {"reload", 1,
     [](Request &r) {
         loaded(r.session).reload();
         done(r);
     }},
    {"flush_coverage", 1,
     [](Request &r) { r.writer.write_unsigned(loaded(r.session).flush_coverage()); }},
    {"symbolise", 2, symbolise_request},
};

} // namespace

Session &loaded(std::unique_ptr<Session> &session) {
    if (session == nullptr) {
        fail("not_loaded");
    }
    return *session;
}

void dispatch(std::unique_ptr<Session> &session, TermReader &reader, Term whole,
              TermWriter &writer) {
    Request request{session, reader, whole, {}, writer};
    unsigned size = 0;
    if (!reader.read_tuple(whole, request.part, kMostParts, size)) {
        request.part[0] = whole;
        size = 1;
    }
    for (const Operation &operation : kOperations) {
        if (operation.size == size && reader.is_atom(request.part[0], operation.name)) {
            return operation.run(request);
        }
    }
    bad_request(request);
}

void call(Session &session, TermReader &reader, Term function, Term arguments, TermWriter &writer) {
    session.function(reader, function).call(session, reader, arguments, writer, session.arena());
}

namespace {

void call_one(Session &session, TermReader &reader, Term one, TermWriter &writer) {
    Term parts[2];
    unsigned count = 0;
    if (!reader.read_tuple(one, parts, 2, count) || count != 2) {
        fail("bad_request", Tree::foreign(reader, one));
    }
    call(session, reader, parts[0], parts[1], writer);
}

} // namespace

void call_batch(Session &session, TermReader &reader, Term calls, TermWriter &writer) {
    ListCursor cursor;
    if (!reader.read_list(calls, cursor)) {
        fail("bad_request", Tree::foreign(reader, calls));
    }
    const std::uint32_t total = cursor.left;
    writer.begin_list(total);
    const std::size_t start = writer.mark();
    std::size_t complete = start;
    try {
        while (cursor.left > 0) {
            complete = writer.mark();
            call_one(session, reader, reader.next(cursor), writer);
        }
    } catch (const Error &error) {
        const std::uint32_t position = total - cursor.left;
        fail("batch", Tree::integer(position),
             Tree::written_list(writer.written(start, complete), position - 1), error.reason());
    }
    writer.end();
}

} // namespace cb
