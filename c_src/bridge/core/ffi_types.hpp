// How libffi is told about C types.
#pragma once

#include "type.hpp"

#include <ffi.h>

#include <deque>
#include <string>
#include <unordered_map>
#include <vector>

namespace cb {

class FfiTypes {
  public:
    // nullptr if values of the type cannot be passed or returned by value (see unsupported()).
    ffi_type *of(const Type &type);

  private:
    struct Composite {
        ffi_type type;
        std::vector<ffi_type *> elements;
    };
    ffi_type *composite(const Type &type);
    std::deque<Composite> composites_;
    std::unordered_map<const Type *, ffi_type *> known_;
};

} // namespace cb
