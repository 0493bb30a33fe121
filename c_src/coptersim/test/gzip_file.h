/* gzip_file.h: the whole content of a gzip-compressed test file, or of a plain one. */
#ifndef GZIP_FILE_H
#define GZIP_FILE_H

#include <cstdio>
#include <cstdlib>
#include <string>
#include <zlib.h>

static inline std::string read_gzip(const char *name) {
    gzFile file = gzopen(name, "rb");
    std::string text;
    char part[65536];
    int got = 0;
    while (file != nullptr && (got = gzread(file, part, sizeof part)) > 0) {
        text.append(part, static_cast<size_t>(got));
    }
    if (file == nullptr || got < 0 || text.empty()) {
        std::fprintf(stderr, "cannot read %s\n", name);
        std::exit(2);
    }
    gzclose(file);
    return text;
}

#endif
