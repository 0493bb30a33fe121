// A shared library in this process: loading, the libraries it needs, its segments, loading it
// afresh.
#pragma once

#include <link.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cb {

// Bytes of a library's memory.
struct Range {
    unsigned char *start;
    std::size_t size;
    bool contains(const void *address) const {
        const auto *byte = static_cast<const unsigned char *>(address);
        return byte >= start && byte < start + size;
    }
};

// One library in the link map.
struct Mapped {
    std::string file;
    std::string soname;
    std::uintptr_t bias = 0; // address in memory minus address in the file
    const link_map *map = nullptr;

    // What the library may write after it has been loaded: writable segments minus RELRO.
    std::vector<Range> writable() const;
    // From the first to the last byte of all its segments.
    Range extent() const;
    bool imports(const char *symbol) const;
    // Entries of .init_array.
    std::size_t constructors() const;
};

// An open library and those it needs, in link order; system libraries and sanitizer runtimes left
// out.
class LoadedLibrary {
  public:
    // Throws Error {load, File, {dlerror, Text}}. A library that this process has already loaded is
    // copied first, so that its state is not shared; `copied` says so.
    explicit LoadedLibrary(const std::string &file);
    ~LoadedLibrary();
    LoadedLibrary(const LoadedLibrary &) = delete;
    LoadedLibrary &operator=(const LoadedLibrary &) = delete;

    const std::string &file() const {
        return file_;
    }
    bool copied() const {
        return copied_;
    }
    // The library itself first.
    const std::vector<Mapped> &all() const {
        return all_;
    }
    // Address of an exported symbol of that library itself; nullptr if it has none.
    static void *symbol_of(const Mapped &library, const char *name);
    // Address of an exported symbol as the library sees it.
    void *symbol(const char *name) const;

    // Closes and opens again. Libraries that stay in memory in spite of that (pinned, or used by
    // somebody else) are named in the result by their soname; the library itself never is: it comes
    // back under a new name.
    std::vector<std::string> reload();

  private:
    void open(const std::string &path);
    void open_copy();
    void close();
    void list();

    std::string file_;
    void *handle_ = nullptr;
    bool copied_ = false;
    std::vector<Mapped> all_;
};

// The file behind a temporary copy that was loaded from `path`, or `path` itself. Safe in a signal
// handler.
const char *original_file(const char *path);

} // namespace cb
