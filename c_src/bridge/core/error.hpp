// The core's one exception: a reason that becomes `{error, Reason}`.
#pragma once

#include "tree.hpp"

#include <exception>

namespace cb {

class Error : public std::exception {
  public:
    explicit Error(Tree reason) : reason_(std::move(reason)) {}
    const Tree &reason() const {
        return reason_;
    }
    const char *what() const noexcept override {
        return "c_bridge error";
    }

  private:
    Tree reason_;
};

template <typename... Rest> [[noreturn]] void fail(const char *tag, Rest... rest) {
    throw Error(Tree::tuple({Tree::atom(tag), std::move(rest)...}));
}

[[noreturn]] inline void fail(const char *atom) {
    throw Error(Tree::atom(atom));
}

// A value that does not fit its C type. The caller knows where and wraps it in its own reason.
class ValueError : public std::exception {
  public:
    explicit ValueError(Tree detail) : detail_(std::move(detail)) {}
    const Tree &detail() const {
        return detail_;
    }

  private:
    Tree detail_;
};

} // namespace cb
