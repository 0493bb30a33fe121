// Stubs that ask Erlang: {0, callback, Name, Args} out, {callback, Value} in. Types are those of
// the stub itself.
#include "server.hpp"

#include "external_term.hpp"

#include "../core/error.hpp"

#include <unistd.h>

#include <cstdio>

namespace cb {

namespace {

const Name kCallback{"callback"};

// A callback runs inside of the library's code: an exception about the channel would be taken for
// one of the library.
[[noreturn]] void end_malformed(const std::exception &error) {
    std::fprintf(stderr, "c_bridge_port: malformed message: %s\n", error.what());
    _exit(kExitMalformed);
}

// The library is in a call, so who answers cannot read memory: text comes as text.
void write_argument(Session &session, TermWriter &writer, const Type &type, const void *argument) {
    const bool is_text = type.spelling.text() == "const char *";
    const char *text = is_text ? *static_cast<const char *const *>(argument) : nullptr;
    if (text != nullptr) {
        writer.write_binary(text);
    } else {
        value_out(session, writer, type, argument);
    }
}

} // namespace

void Server::ask(const char *name, void **arguments, void *result) {
    const Prototype &prototype = session_->function(std::string(name)).prototype();
    EiWriter writer;
    writer.begin_tuple(4);
    writer.write_signed(0);
    writer.write_name(kCallback);
    writer.write_atom(name);
    writer.begin_list(static_cast<unsigned>(prototype.parameters.size()));
    for (std::size_t i = 0; i < prototype.parameters.size(); ++i) {
        write_argument(*session_, writer, *prototype.parameters[i].type, arguments[i]);
    }
    writer.end();
    writer.end();
    channel_.write(writer.packet());
    read_answer(name, *prototype.result, result);
}

Term Server::next_answer(std::vector<char> &packet, EiReader &reader) {
    try {
        if (!channel_.read(packet)) {
            _exit(kExitOk); // nobody is there any more to make this call for
        }
        reader.begin(packet.data(), packet.size());
        Term parts[2];
        unsigned count = 0;
        if (!reader.read_tuple(reader.root(), parts, 2, count) || count != 2 ||
            !reader.is_atom(parts[0], kCallback)) {
            throw MalformedTerm("a message that is not {callback, Value}", 1);
        }
        return parts[1];
    } catch (const MalformedTerm &error) {
        end_malformed(error);
    } catch (const BrokenChannel &error) {
        end_malformed(error);
    }
}

void Server::read_answer(const char *name, const Type &type, void *result) {
    std::vector<char> packet;
    EiReader reader;
    const Term value = next_answer(packet, reader);
    if (result == nullptr) {
        return;
    }
    try {
        value_in(*session_, reader, value, type, result, session_->kept());
    } catch (const ValueError &error) {
        // The value is shown in words: its message ends with this function.
        fail("callback", Tree::atom(name), error.detail().owned());
    }
}

} // namespace cb
