// Reading and writing memory that a pointer of the library under test leads to, which may be
// anywhere.
#pragma once

#include <cstddef>

namespace cb {

// False if not all of it can be read (written); then nothing useful has been copied. The kernel
// does the copying, so that a wild pointer is an error and not the end of the process.
bool read_safely(void *to, const void *from, std::size_t size);
bool write_safely(void *to, const void *from, std::size_t size);

} // namespace cb
