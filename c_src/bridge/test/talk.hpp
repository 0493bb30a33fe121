// A conversation with the core in texts: talk("{call,add,[1,2]}") gives "3", or "error: Reason".
//
// A reply can be kept under a name and used in later requests: keep("P", request), then "$P".
#pragma once

#include "text_terms.hpp"

#include "../core/dispatch.hpp"

#include <map>
#include <memory>
#include <string>

namespace cb {

class Talk {
  public:
    // Loads the library; aborts the test if that fails.
    explicit Talk(const std::string &library, const std::string &options = "#{}");
    Talk() = default;
    std::string operator()(const std::string &request);
    std::string keep(const std::string &name, const std::string &request);
    // Compares and reports a difference; true if there is none.
    bool is(const std::string &request, const std::string &expected, int line);
    void end() {
        session_.reset();
    }

  private:
    std::unique_ptr<Session> session_;
    std::map<std::string, std::string> kept_;
};

} // namespace cb

#define IS(talk, request, expected) CHECK((talk).is(request, expected, __LINE__))
