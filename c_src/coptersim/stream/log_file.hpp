/* log_file.hpp: writes an LCM log, whole or not at all. The times are simulated ones, so the same
 * messages give the same bytes. */
#ifndef CSIM_STREAM_LOG_FILE_HPP
#define CSIM_STREAM_LOG_FILE_HPP

#include "sink.hpp"

#include <cstdio>

namespace coptersim_stream {

class log_file : public sink {
  public:
    log_file() = default;
    /* What was not finished disappears. */
    ~log_file() override;
    log_file(const log_file &) = delete;
    log_file &operator=(const log_file &) = delete;

    /* Devices, pipes and links are written to directly, anything else under a temporary name.
     * false: error is one line. */
    bool open(const std::string &file, std::string &error);
    bool put(std::uint64_t t_us, const char *channel, std::string_view bytes,
             std::string &error) override;
    /* The file gets its name. */
    bool finish(std::string &error);

  private:
    bool failed(std::string &error) const;

    std::string file_, temporary_; /* temporary_ is empty when written directly */
    std::FILE *stream_ = nullptr;
    std::uint64_t number_ = 0;
};

} // namespace coptersim_stream

#endif
