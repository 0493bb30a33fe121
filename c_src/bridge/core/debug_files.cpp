#include "debug_files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

namespace cb {

namespace {

// The checksum of .gnu_debuglink: CRC-32 of ISO 3309, reflected polynomial 0xEDB88320.
std::uint32_t debuglink_checksum(int fd) {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t i = 0; i < table.size(); ++i) {
        std::uint32_t value = i;
        for (int bit = 0; bit < 8; ++bit) {
            value = (value >> 1) ^ ((value & 1U) != 0 ? 0xEDB88320U : 0U);
        }
        table[i] = value;
    }
    std::vector<unsigned char> block(64 * 1024);
    std::uint32_t checksum = 0xFFFFFFFFU;
    ssize_t got = 0;
    while ((got = read(fd, block.data(), block.size())) > 0) {
        for (ssize_t i = 0; i < got; ++i) {
            checksum =
                table[(checksum ^ block[static_cast<std::size_t>(i)]) & 0xFFU] ^ (checksum >> 8);
        }
    }
    lseek(fd, 0, SEEK_SET);
    return ~checksum;
}

int open_matching(const std::string &path, std::uint32_t checksum) {
    const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd >= 0 && debuglink_checksum(fd) != checksum) {
        close(fd);
        return -1;
    }
    return fd;
}

int find_debug_file(Dwfl_Module *module, void **userdata, const char *name, Dwarf_Addr base,
                    const char *file, const char *link, GElf_Word checksum, char **found) {
    const int by_id =
        dwfl_build_id_find_debuginfo(module, userdata, name, base, file, link, checksum, found);
    if (by_id >= 0 || link == nullptr || file == nullptr) {
        return by_id;
    }
    const std::string path(file);
    const std::size_t slash = path.rfind('/');
    const std::string folder = slash == std::string::npos ? "." : path.substr(0, slash);
    for (const std::string &place :
         {folder + "/", folder + "/.debug/", "/usr/lib/debug" + folder + "/"}) {
        const std::string candidate = place + link;
        const int fd = candidate == path ? -1 : open_matching(candidate, checksum);
        if (fd >= 0) {
            *found = strdup(candidate.c_str());
            return fd;
        }
    }
    return -1;
}

char *default_debug_path = nullptr;

} // namespace

const Dwfl_Callbacks &local_debug_files() {
    static const Dwfl_Callbacks callbacks = {dwfl_build_id_find_elf, find_debug_file,
                                             dwfl_offline_section_address, &default_debug_path};
    return callbacks;
}

} // namespace cb
