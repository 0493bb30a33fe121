#include "stub_callback.h"

#include "external_term.hpp"
#include "server.hpp"

#include "../core/convert_scalar.hpp"
#include "../core/error.hpp"

#include <unistd.h>

#include <string>

namespace cb {

namespace {

const Name kCallback{"callback"};

Type type_of(const cb_stub_value &value) {
    Type type;
    type.size = value.size;
    switch (value.kind) {
    case CB_STUB_SIGNED:
        type.kind = Kind::Signed;
        type.spelling = "int" + std::to_string(8 * value.size) + "_t";
        break;
    case CB_STUB_UNSIGNED:
        type.kind = Kind::Unsigned;
        type.spelling = "uint" + std::to_string(8 * value.size) + "_t";
        break;
    case CB_STUB_BOOL:
        type.kind = Kind::Bool;
        type.spelling = "bool";
        break;
    case CB_STUB_FLOAT:
        type.kind = Kind::Float;
        type.size = sizeof(double);
        type.spelling = "double";
        break;
    default:
        type.spelling = "void *";
    }
    return type;
}

} // namespace

void Server::write_stub_value(TermWriter &writer, const cb_stub_value &value) {
    const Type type = type_of(value);
    const auto *text = static_cast<const char *>(value.as.p);
    switch (value.kind) {
    case CB_STUB_SIGNED:
        return writer.write_signed(value.as.i);
    case CB_STUB_UNSIGNED:
        return writer.write_unsigned(value.as.u);
    case CB_STUB_BOOL:
        return integer_out(writer, type, value.as.u, 8);
    case CB_STUB_FLOAT:
        return float_out(writer, type, &value.as.d);
    case CB_STUB_STRING:
        return text == nullptr ? writer.write_atom("null") : writer.write_binary(text);
    case CB_STUB_POINTER:
        return write_pointer(*session_, writer, const_cast<void *>(value.as.p),
                             session_->type_named("void"));
    default:
        return writer.write_atom("ok");
    }
}

void Server::read_stub_value(EiReader &reader, Term term, const char *name, cb_stub_value &value) {
    const Type type = type_of(value);
    const auto bits = static_cast<unsigned>(8 * value.size);
    try {
        switch (value.kind) {
        case CB_STUB_SIGNED: {
            const std::uint64_t number = integer_in(reader, term, type, bits);
            value.as.i = static_cast<std::int64_t>(number << (64 - bits)) >> (64 - bits);
            break;
        }
        case CB_STUB_UNSIGNED:
        case CB_STUB_BOOL:
            value.as.u = integer_in(reader, term, type, bits);
            break;
        case CB_STUB_FLOAT:
            float_in(reader, term, type, &value.as.d);
            break;
        case CB_STUB_POINTER:
            if (!looks_like_pointer(reader, term)) {
                bad_value("bad_type", type, reader, term);
            }
            value.as.p = read_pointer(*session_, reader, term).address;
            break;
        default:
            break;
        }
    } catch (const ValueError &error) {
        fail("callback", Tree::atom(name), error.detail());
    }
}

void Server::ask(const char *name, const cb_stub_value *args, int count, cb_stub_value &result) {
    EiWriter writer;
    writer.begin_tuple(4);
    writer.write_signed(0);
    writer.write_name(kCallback);
    writer.write_atom(name);
    writer.begin_list(static_cast<unsigned>(count));
    for (int i = 0; i < count; ++i) {
        write_stub_value(writer, args[i]);
    }
    writer.end();
    writer.end();
    channel_.write(writer.packet());

    std::vector<char> packet;
    if (!channel_.read(packet)) {
        _exit(kExitOk);
    }
    EiReader reader;
    reader.begin(packet.data(), packet.size());
    Term parts[2];
    unsigned size = 0;
    if (!reader.read_tuple(reader.root(), parts, 2, size) || size != 2 ||
        !reader.is_atom(parts[0], kCallback)) {
        throw MalformedTerm("a message that is not {callback, Value}", 1);
    }
    read_stub_value(reader, parts[1], name, result);
}

} // namespace cb

extern "C" __attribute__((visibility("default"))) void
cb_stub_call(const char *name, const cb_stub_value *args, int count, cb_stub_value *result) {
    cb::Server::current()->ask(name, args, count, *result);
}
