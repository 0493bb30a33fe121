// What arrives at the port program: decoded and carried out, whatever it is.
#include "../core/dispatch.hpp"
#include "../core/error.hpp"
#include "../port/ei_terms.hpp"
#include "../port/external_term.hpp"

#include <new>

namespace {

std::unique_ptr<cb::Session> &session() {
    static auto loaded = std::make_unique<cb::Session>(FUZZ_TARGET, cb::LoadOptions{});
    return loaded;
}

// As the server does it, without the pipe. False if there is nothing to answer.
bool serve(cb::EiReader &reader, cb::EiWriter &writer) {
    cb::Term parts[2];
    unsigned count = 0;
    if (!reader.read_tuple(reader.root(), parts, 2, count) || count != 2) {
        return false;
    }
    try {
        writer.begin();
        writer.begin_tuple(2);
        writer.write_term(reader, parts[0]);
        cb::dispatch(session(), reader, parts[1], writer);
    } catch (const cb::Error &error) {
        writer.begin();
        writer.begin_tuple(2);
        writer.write_term(reader, parts[0]);
        error.reason().write(writer);
    } catch (const std::bad_alloc &) {
        return false;
    }
    writer.end();
    return true;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    static cb::EiReader reader;
    static cb::EiWriter writer;
    session()->forget_pointers();
    try {
        reader.begin(reinterpret_cast<const char *>(data), size);
    } catch (const cb::MalformedTerm &) {
        return 0;
    }
    if (!serve(reader, writer)) {
        return 0;
    }
    // What is answered must be well formed itself.
    const std::string_view packet = writer.packet();
    cb::EiReader answer;
    answer.begin(packet.data() + 4, packet.size() - 4);
    return 0;
}
