// How an error reaches the user: thread's last error, context's counter, context's callback.
#pragma once

#include "fc.h"

#include <string>
#include <vector>

namespace fc {

struct Report {
    int code;
    fc_fault_id fault; // 0: none
    bool first;        // this fault has not met this cause before
    std::string text;
};

// Collected while locks are held, delivered afterwards.
class Reports {
  public:
    void add(int code, fc_fault_id fault, bool first, std::string text);
    // The code of the earliest, or FC_OK.
    int code() const {
        return reports_.empty() ? FC_OK : reports_.front().code;
    }
    bool empty() const {
        return reports_.empty();
    }
    // Without any lock held.
    void deliver(fc_context &context) const;

  private:
    std::vector<Report> reports_;
};

// One error at once, without any lock held. Returns the code.
int report(fc_context &context, int code, const char *text);

// An identifier in a message: quoted, control characters escaped, long ones cut.
std::string quoted(const std::string &identifier);
std::string quoted(const char *identifier);

// A formatted line, cut at 300 characters.
__attribute__((format(printf, 1, 2))) std::string format(const char *pattern, ...);

} // namespace fc
