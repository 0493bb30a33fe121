// How an error reaches the user: thread's last error, context's counter, context's callback.
#pragma once

#include "fc.h"

#include <memory>
#include <vector>

namespace fc {

// A line of text that needs no memory from the heap: errors are told also when there is none.
struct Text {
    char chars[304];
    const char *c_str() const {
        return chars;
    }
};

struct Report {
    int code;
    fc_fault_id fault; // 0: none
    bool first;        // this fault has not met this cause before
    Text text;
};

// Collected while locks are held, delivered afterwards.
class Reports {
  public:
    void add(int code, fc_fault_id fault, bool first, const Text &text) noexcept;
    // The code of the earliest, or FC_OK.
    int code() const {
        return first_;
    }
    bool empty() const {
        return first_ == FC_OK;
    }
    // Without any lock held.
    void deliver(fc_context &context) const;

  private:
    // Two words: a probe call that goes well pays for making this.
    std::unique_ptr<std::vector<Report>> reports_;
    int first_ = FC_OK;
    unsigned lost_ = 0; // for want of memory
};

// One error at once, without any lock held. Returns the code.
int report(fc_context &context, int code, const Text &text);

int report_no_memory(fc_context &context);

// An identifier in a message: quoted, control characters escaped, long ones cut.
Text quoted(const char *identifier);

__attribute__((format(printf, 1, 2))) Text format(const char *pattern, ...);

} // namespace fc
