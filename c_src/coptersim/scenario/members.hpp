/* members.hpp: the members of a JSON object, asked for one by one; whatever has not been asked for
 * at the end is unknown. Every function throws located_error when the value is not as asked. */
#ifndef CSIM_MEMBERS_HPP
#define CSIM_MEMBERS_HPP

#include "located_json.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace csim_scenario {

constexpr std::uint64_t largest_whole = std::uint64_t{1} << 53;

/* Values on their own; where names them in messages. */
double as_number(const node &value, const std::string &where);
std::uint64_t as_whole(const node &value, const std::string &where, std::uint64_t least,
                       std::uint64_t most);
const std::string &as_text(const node &value, std::string_view where);
bool as_truth(const node &value, const std::string &where);
/* Exactly so many numbers. */
std::vector<double> as_numbers(const node &value, const std::string &where, std::size_t count);
/* At most so many items. */
const std::vector<node> &as_array(const node &value, std::string_view where, std::size_t most);

class members {
  public:
    /* where: "copters[3]", "" for the whole file. */
    members(const node &object, std::string where);

    int line() const {
        return object_.line;
    }
    /* "where.name". */
    std::string path(const std::string &name) const;

    /* NULL when it is missing. */
    const node *find(const char *name);
    const node &need(const char *name);

    double number(const char *name, double otherwise);
    std::uint64_t whole(const char *name, std::uint64_t least, std::uint64_t most);
    std::uint64_t whole(const char *name, std::uint64_t least, std::uint64_t most,
                        std::uint64_t otherwise);
    std::int32_t id(const char *name);
    std::string text(const char *name);
    std::string text(const char *name, const std::string &otherwise);

    /* Members not asked for so far, "class", "description" and "x_..." left out. */
    std::vector<std::size_t> others() const;
    const std::string &key(std::size_t index) const {
        return object_.keys[index];
    }
    const node &value(std::size_t index) const {
        return object_.items[index];
    }

    /* Throws when there are others. */
    void finish() const;

  private:
    const node &object_;
    std::string where_;
    std::vector<bool> asked_;
    std::string known_; /* names asked for, for messages */
};

} // namespace csim_scenario

#endif
