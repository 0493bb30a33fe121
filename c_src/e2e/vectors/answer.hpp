// Answers one request of the vector runner.
#ifndef E2E_VECTORS_ANSWER_HPP
#define E2E_VECTORS_ANSWER_HPP

#include <string>

namespace e2e_vectors {

// From one line to one line; never throws for anything a line can hold.
std::string answer(const std::string &line);

} // namespace e2e_vectors

#endif
