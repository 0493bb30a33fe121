// A program under test, with pipes to its standard input and output.
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace cb {

class Child {
  public:
    explicit Child(const std::vector<std::string> &command);
    ~Child();
    Child(const Child &) = delete;
    Child &operator=(const Child &) = delete;

    pid_t pid() const {
        return pid_;
    }
    void write(const std::string &bytes) const;
    void close_input();
    // Up to `size` bytes; fewer at the end of output.
    std::string read(std::size_t size) const;
    // Status in the manner of a shell: 128 + N for signal N.
    int wait();

  private:
    pid_t pid_ = -1;
    int in_ = -1;
    int out_ = -1;
};

std::string file_text(const std::string &path);
// Waits until there is no process of that id (any more); the test's alarm ends a wait in vain.
void await_death(pid_t pid);
// Whether it is gone, or waits only to be reaped by whoever inherited it.
bool is_dead(pid_t pid);

} // namespace cb
