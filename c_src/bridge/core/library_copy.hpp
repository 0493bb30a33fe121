// A copy of a library under a new name, for as long as it takes to load it.
#pragma once

#include <string>

namespace cb {

// Placed next to the original if possible (so that $ORIGIN still leads to the libraries it needs),
// else in the folder for temporary files. The file is removed with this object; original_file()
// goes on knowing its name.
class TemporaryCopy {
  public:
    explicit TemporaryCopy(const std::string &file);
    ~TemporaryCopy();
    TemporaryCopy(const TemporaryCopy &) = delete;
    TemporaryCopy &operator=(const TemporaryCopy &) = delete;
    const std::string &path() const {
        return path_;
    }

  private:
    std::string path_;
};

} // namespace cb
