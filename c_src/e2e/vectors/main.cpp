// e2e_vectors: puts test vectors to libe2e. One JSON request a line on standard input, one JSON
// reply a line on standard output; e2e.md section 10 says what they hold. Beyond it: the ops
// `check_config` and `sm_check_config`, which reply {"ret":N}. No state is kept between lines.
#include "answer.hpp"
#include <iostream>

int main() {
    std::ios::sync_with_stdio(false);
    std::string line;
    while (std::getline(std::cin, line)) {
        std::cout << e2e_vectors::answer(line) << std::endl;
    }
    return 0;
}
