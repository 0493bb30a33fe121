#include "talk.hpp"

#include "../core/error.hpp"

#include <cstdio>
#include <cstdlib>

namespace cb {

Talk::Talk(const std::string &library, const std::string &options) {
    const std::string reply = (*this)("{load,<<\"" + library + "\">>," + options + "}");
    if (session_ == nullptr) {
        std::fprintf(stderr, "cannot load %s: %s\n", library.c_str(), reply.c_str());
        std::abort();
    }
}

std::string Talk::operator()(const std::string &text) {
    std::string request = text;
    for (const auto &[name, value] : kept_) {
        for (std::size_t at = request.find("$" + name); at != std::string::npos;
             at = request.find("$" + name)) {
            request.replace(at, name.size() + 1, value);
        }
    }
    TextReader reader;
    TextWriter writer;
    try {
        dispatch(session_, reader, reader.parse(request), writer);
        return writer.text();
    } catch (const Error &error) {
        writer.begin();
        error.reason().write(writer);
        return "error: " + writer.text();
    }
}

std::string Talk::keep(const std::string &name, const std::string &request) {
    return kept_[name] = (*this)(request);
}

bool Talk::is(const std::string &request, const std::string &expected, int line) {
    const std::string got = (*this)(request);
    if (got != expected) {
        std::fprintf(stderr, "line %d: %s\n  gives    %s\n  expected %s\n", line, request.c_str(),
                     got.c_str(), expected.c_str());
    }
    return got == expected;
}

} // namespace cb
