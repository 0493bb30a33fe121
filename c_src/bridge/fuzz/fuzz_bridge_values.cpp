// Values of any shape into C types: either refused, or read back as a value that gives the same
// bytes again.
#include "../core/error.hpp"
#include "../core/session.hpp"
#include "../port/ei_terms.hpp"
#include "../port/external_term.hpp"

#include <cstdlib>
#include <cstring>
#include <new>

namespace {

const char *const kTypes[] = {
    "int8_t",          "uint8_t",      "int16_t",           "uint16_t", "int",
    "unsigned int",    "int64_t",      "uint64_t",          "bool",     "float",
    "double",          "long double",  "enum level",        "char[5]",  "int[2][3]",
    "struct point",    "struct flags", "struct everything", "char *",   "struct point *",
    "struct pointing", "union number", "int *[2]"};
constexpr std::size_t kTypeCount = sizeof kTypes / sizeof *kTypes;

cb::Session &session() {
    static cb::Session loaded(FUZZ_TARGET, cb::LoadOptions{});
    return loaded;
}

// References differ from one conversion to the next, and NaN has many forms.
bool has_one_form(const cb::Type &type) {
    switch (type.kind) {
    case cb::Kind::Pointer:
    case cb::Kind::Union:
    case cb::Kind::Float:
        return false;
    case cb::Kind::Array:
        return has_one_form(type.target());
    case cb::Kind::Struct:
        for (const cb::Member &member : type.members) {
            if (!has_one_form(*member.type)) {
                return false;
            }
        }
        return true;
    default:
        return true;
    }
}

void convert(const cb::Type &type, cb::EiReader &reader) {
    cb::Arena arena;
    std::vector<unsigned char> first(type.size);
    std::vector<unsigned char> second(type.size);
    try {
        cb::value_in(session(), reader, reader.root(), type, first.data(), arena);
    } catch (const cb::ValueError &error) {
        cb::EiWriter writer;
        error.detail().write(writer);
        return;
    } catch (const cb::Error &) {
        return;
    } catch (const std::bad_alloc &) {
        return;
    }
    cb::EiWriter writer;
    cb::value_out(session(), writer, type, first.data());
    const std::string_view packet = writer.packet();
    cb::EiReader again;
    again.begin(packet.data() + 4, packet.size() - 4);
    cb::value_in(session(), again, again.root(), type, second.data(), arena);
    if (has_one_form(type) && std::memcmp(first.data(), second.data(), type.size) != 0) {
        std::abort();
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    if (size < 1) {
        return 0;
    }
    session().forget_pointers();
    cb::EiReader reader;
    try {
        reader.begin(reinterpret_cast<const char *>(data) + 1, size - 1);
    } catch (const cb::MalformedTerm &) {
        return 0;
    }
    convert(session().type_named(kTypes[data[0] % kTypeCount]), reader);
    return 0;
}
