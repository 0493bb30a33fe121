/* located_json.hpp: a JSON text as a tree whose nodes know their line, so that whoever reads it can
 * say where something is wrong. The syntax is nlohmann-json's business. */
#ifndef CSIM_LOCATED_JSON_HPP
#define CSIM_LOCATED_JSON_HPP

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace csim_scenario {

/* What is wrong, and in which line (from 1; 0: no particular one). */
struct located_error : std::runtime_error {
    located_error(int at_line, const std::string &reason)
        : std::runtime_error(reason), line(at_line) {}
    int line;
};

struct node {
    enum kind_type : std::uint8_t { null, boolean, number, text, array, object };

    kind_type kind = null;
    bool truth = false;            /* boolean */
    bool whole = false;            /* number: written as an integer, and it is in integer */
    int line = 0;                  /* where it ends; of arrays and objects, where they begin */
    double real = 0;               /* number */
    std::uint64_t integer = 0;     /* number, not negative, when whole */
    std::string characters;        /* text */
    std::vector<std::string> keys; /* object: of items, in the order of the file */
    std::vector<node> items;       /* array, object */
};

/* For messages: "a number", "an object" ... */
const char *kind_name(node::kind_type kind);

/* Throws located_error: not JSON, a key twice in one object, nested deeper than 32 levels. */
node parse_located(std::string_view text);

} // namespace csim_scenario

#endif
