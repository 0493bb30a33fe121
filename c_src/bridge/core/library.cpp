#include "library.hpp"

#include "error.hpp"
#include "library_copy.hpp"

#include <dlfcn.h>
#include <elf.h>

#include <algorithm>
#include <array>
#include <climits>
#include <cstdlib>
#include <cstring>

namespace cb {

namespace {

// Sonames begin with one of these. Their state is the process's own and must not be reset.
constexpr std::array<const char *, 16> kSystemLibraries = {
    "libc.so",   "libm.so",      "libstdc++.so", "libgcc_s.so", "ld-linux",   "libpthread.so",
    "libdl.so",  "librt.so",     "libasan.so",   "libubsan.so", "libtsan.so", "liblsan.so",
    "libc++.so", "libc++abi.so", "libclang_rt",  "linux-vdso"};

bool is_system(const std::string &soname) {
    return std::any_of(kSystemLibraries.begin(), kSystemLibraries.end(), [&](const char *prefix) {
        return soname.compare(0, std::strlen(prefix), prefix) == 0;
    });
}

std::string last_part(const std::string &path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? path : path.substr(slash + 1);
}

std::uint64_t dynamic_value(const link_map *map, ElfW(Sxword) tag) {
    for (const ElfW(Dyn) *entry = map->l_ld; entry->d_tag != DT_NULL; ++entry) {
        if (entry->d_tag == tag) {
            return entry->d_un.d_val;
        }
    }
    return 0;
}

// glibc turns these entries into addresses when it loads a library, unless the section is
// read-only.
template <typename T> const T *dynamic_address(const link_map *map, ElfW(Sxword) tag) {
    const std::uint64_t value = dynamic_value(map, tag);
    return reinterpret_cast<const T *>(value != 0 && value < map->l_addr ? value + map->l_addr
                                                                         : value);
}

const char *dynamic_strings(const link_map *map) {
    return dynamic_address<char>(map, DT_STRTAB);
}

std::vector<std::string> dynamic_texts(const link_map *map, ElfW(Sxword) tag) {
    std::vector<std::string> texts;
    const char *strings = dynamic_strings(map);
    for (const ElfW(Dyn) *entry = map->l_ld; strings != nullptr && entry->d_tag != DT_NULL;
         ++entry) {
        if (entry->d_tag == tag) {
            texts.emplace_back(strings + entry->d_un.d_val);
        }
    }
    return texts;
}

Mapped describe(const link_map *map) {
    Mapped mapped;
    mapped.file = original_file(map->l_name);
    const auto names = dynamic_texts(map, DT_SONAME);
    mapped.soname = names.empty() ? last_part(mapped.file) : names.front();
    mapped.bias = map->l_addr;
    mapped.map = map;
    return mapped;
}

const link_map *find_in_process(const link_map *any, const std::string &soname) {
    while (any->l_prev != nullptr) {
        any = any->l_prev;
    }
    for (; any != nullptr; any = any->l_next) {
        if (any->l_name[0] != '\0' &&
            (last_part(any->l_name) == soname || describe(any).soname == soname)) {
            return any;
        }
    }
    return nullptr;
}

struct SegmentSearch {
    const Mapped *library;
    std::vector<Range> writable;
    std::uintptr_t lowest;
    std::uintptr_t highest;
};

void add_segment(std::vector<Range> &out, const ElfW(Phdr) & segment, const ElfW(Phdr) * relro,
                 std::uintptr_t bias) {
    std::uintptr_t start = bias + segment.p_vaddr;
    const std::uintptr_t end = start + segment.p_memsz;
    if (relro != nullptr && relro->p_vaddr >= segment.p_vaddr &&
        relro->p_vaddr < segment.p_vaddr + segment.p_memsz) {
        const std::uintptr_t protected_end = bias + relro->p_vaddr + relro->p_memsz;
        start = std::max(start, protected_end & ~std::uintptr_t{4095});
    }
    if (start < end) {
        out.push_back(Range{reinterpret_cast<unsigned char *>(start), end - start});
    }
}

int collect_segments(dl_phdr_info *info, std::size_t, void *data) {
    auto *search = static_cast<SegmentSearch *>(data);
    if (info->dlpi_addr != search->library->bias ||
        std::strcmp(info->dlpi_name, search->library->map->l_name) != 0) {
        return 0;
    }
    const ElfW(Phdr) *relro = nullptr;
    for (int i = 0; i < info->dlpi_phnum; ++i) {
        if (info->dlpi_phdr[i].p_type == PT_GNU_RELRO) {
            relro = &info->dlpi_phdr[i];
        }
    }
    for (int i = 0; i < info->dlpi_phnum; ++i) {
        const ElfW(Phdr) &segment = info->dlpi_phdr[i];
        if (segment.p_type != PT_LOAD) {
            continue;
        }
        search->lowest = std::min(search->lowest, info->dlpi_addr + segment.p_vaddr);
        search->highest =
            std::max(search->highest, info->dlpi_addr + segment.p_vaddr + segment.p_memsz);
        if ((segment.p_flags & PF_W) != 0) {
            add_segment(search->writable, segment, relro, info->dlpi_addr);
        }
    }
    return 1;
}

std::string last_dlerror() {
    const char *text = dlerror();
    return text != nullptr ? text : "unknown error of the dynamic linker";
}

} // namespace

std::vector<Range> Mapped::writable() const {
    SegmentSearch search{this, {}, UINTPTR_MAX, 0};
    dl_iterate_phdr(collect_segments, &search);
    return search.writable;
}

Range Mapped::extent() const {
    SegmentSearch search{this, {}, UINTPTR_MAX, 0};
    dl_iterate_phdr(collect_segments, &search);
    return Range{reinterpret_cast<unsigned char *>(search.lowest),
                 search.lowest < search.highest ? search.highest - search.lowest : 0};
}

bool Mapped::imports(const char *symbol) const {
    const auto *symbols = dynamic_address<ElfW(Sym)>(map, DT_SYMTAB);
    const char *strings = dynamic_strings(map);
    const auto *relocations = dynamic_address<ElfW(Rela)>(map, DT_JMPREL);
    const auto named = [&](const ElfW(Rela) & relocation) {
        const ElfW(Sym) &target = symbols[ELF64_R_SYM(relocation.r_info)];
        return target.st_shndx == SHN_UNDEF && std::strcmp(strings + target.st_name, symbol) == 0;
    };
    if (symbols == nullptr || strings == nullptr) {
        return false;
    }
    const std::size_t lazy = dynamic_value(map, DT_PLTRELSZ) / sizeof(ElfW(Rela));
    const auto *others = dynamic_address<ElfW(Rela)>(map, DT_RELA);
    const std::size_t eager = dynamic_value(map, DT_RELASZ) / sizeof(ElfW(Rela));
    return std::any_of(relocations, relocations + lazy, named) ||
           std::any_of(others, others + eager, named);
}

std::size_t Mapped::constructors() const {
    return dynamic_value(map, DT_INIT_ARRAYSZ) / sizeof(void *);
}

LoadedLibrary::LoadedLibrary(const std::string &file) : file_(file) {
    char *full = realpath(file.c_str(), nullptr);
    if (full != nullptr) {
        file_ = full;
        std::free(full);
    }
    void *present = dlopen(file_.c_str(), RTLD_NOW | RTLD_NOLOAD);
    if (present != nullptr) {
        dlclose(present);
        open_copy();
    } else {
        open(file_);
    }
    list();
}

LoadedLibrary::~LoadedLibrary() {
    close();
}

void LoadedLibrary::open(const std::string &path) {
    handle_ = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle_ == nullptr) {
        fail("load", Tree::binary(file_),
             Tree::tuple({Tree::atom("dlerror"), Tree::binary(last_dlerror())}));
    }
}

void LoadedLibrary::open_copy() {
    const TemporaryCopy copy(file_);
    open(copy.path());
    copied_ = true;
}

void LoadedLibrary::close() {
    if (handle_ != nullptr) {
        dlclose(handle_);
        handle_ = nullptr;
    }
}

void LoadedLibrary::list() {
    all_.clear();
    link_map *map = nullptr;
    dlinfo(handle_, RTLD_DI_LINKMAP, &map);
    all_.push_back(describe(map));
    for (std::size_t i = 0; i < all_.size(); ++i) {
        for (const std::string &needed : dynamic_texts(all_[i].map, DT_NEEDED)) {
            const link_map *found = is_system(needed) ? nullptr : find_in_process(map, needed);
            const bool known = std::any_of(all_.begin(), all_.end(),
                                           [&](const Mapped &m) { return m.map == found; });
            if (found != nullptr && !known && !is_system(describe(found).soname)) {
                all_.push_back(describe(found));
            }
        }
    }
}

void *LoadedLibrary::symbol_of(const Mapped &library, const char *name) {
    void *handle = dlopen(library.map->l_name, RTLD_NOW | RTLD_NOLOAD);
    void *address = handle != nullptr ? dlsym(handle, name) : nullptr;
    Dl_info info;
    link_map *owner = nullptr;
    const bool own =
        address != nullptr &&
        dladdr1(address, &info, reinterpret_cast<void **>(&owner), RTLD_DL_LINKMAP) != 0 &&
        owner == library.map;
    if (handle != nullptr) {
        dlclose(handle);
    }
    return own ? address : nullptr;
}

void *LoadedLibrary::symbol(const char *name) const {
    return dlsym(handle_, name);
}

std::vector<std::string> LoadedLibrary::reload() {
    std::vector<std::pair<std::string, std::string>> others; // name in the link map, soname
    for (std::size_t i = 1; i < all_.size(); ++i) {
        others.emplace_back(all_[i].map->l_name, all_[i].soname);
    }
    const std::string path = all_.front().map->l_name;
    close();
    std::vector<std::string> pinned;
    for (const auto &[name, soname] : others) {
        void *present = dlopen(name.c_str(), RTLD_NOW | RTLD_NOLOAD);
        if (present != nullptr) {
            pinned.push_back(soname);
            dlclose(present);
        }
    }
    void *present = dlopen(path.c_str(), RTLD_NOW | RTLD_NOLOAD);
    if (present != nullptr) {
        dlclose(present);
        open_copy();
    } else if (copied_) {
        open_copy();
    } else {
        open(file_);
    }
    list();
    return pinned;
}

} // namespace cb
