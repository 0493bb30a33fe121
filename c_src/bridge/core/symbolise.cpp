// From module and offset to function, file and line.
#include "session.hpp"

#include "debug_files.hpp"
#include "dwarf_die.hpp"

#include <cxxabi.h>
#include <dwarf.h>
#include <elfutils/libdwfl.h>
#include <sys/stat.h>

#include <cstdlib>

namespace cb {

namespace {

struct DwflEnd {
    void operator()(Dwfl *dwfl) const {
        dwfl_end(dwfl);
    }
};

struct OpenModule {
    std::unique_ptr<Dwfl, DwflEnd> dwfl;
    Dwfl_Module *module = nullptr;
    Dwarf_Addr start = 0;
};

OpenModule open_module(const std::string &file) {
    OpenModule opened;
    struct stat status;
    if (stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) {
        return opened;
    }
    opened.dwfl.reset(dwfl_begin(&local_debug_files()));
    if (opened.dwfl == nullptr) {
        return opened;
    }
    dwfl_report_begin(opened.dwfl.get());
    opened.module = dwfl_report_offline(opened.dwfl.get(), file.c_str(), file.c_str(), -1);
    dwfl_report_end(opened.dwfl.get(), nullptr, nullptr);
    if (opened.module != nullptr) {
        GElf_Addr bias = 0;
        dwfl_module_getelf(opened.module, &bias);
        opened.start = bias;
    }
    return opened;
}

std::string readable(const char *name) {
    int status = 0;
    char *text = abi::__cxa_demangle(name, nullptr, nullptr, &status);
    std::string result = text != nullptr ? text : name;
    std::free(text);
    return result;
}

// The innermost function, inlined or not, that the address belongs to.
std::string function_at(const OpenModule &opened, Dwarf_Addr address) {
    Dwarf_Addr bias = 0;
    Dwarf_Die *unit = dwfl_module_addrdie(opened.module, address, &bias);
    Dwarf_Die *scopes = nullptr;
    const int count = unit != nullptr ? dwarf_getscopes(unit, address - bias, &scopes) : 0;
    std::string name;
    for (int i = 0; i < count && name.empty(); ++i) {
        const int tag = dwarf_tag(&scopes[i]);
        const char *plain = text_attribute(scopes[i], DW_AT_name);
        if ((tag == DW_TAG_subprogram || tag == DW_TAG_inlined_subroutine) && plain != nullptr) {
            name = plain;
        }
    }
    std::free(scopes);
    if (name.empty()) {
        const char *symbol = dwfl_module_addrname(opened.module, address);
        name = symbol != nullptr ? readable(symbol) : "??";
    }
    return name;
}

Tree describe(const OpenModule &opened, const Frame &frame) {
    if (opened.module == nullptr) {
        return Tree::tuple({Tree::binary("??"), Tree::binary(""), Tree::integer(0)});
    }
    // A return address may lie behind the end of a function that never returns.
    const Dwarf_Addr address = opened.start + frame.offset - (frame.exact ? 0 : 1);
    int line = 0;
    const char *file = nullptr;
    if (Dwfl_Line *found = dwfl_module_getsrc(opened.module, address)) {
        file = dwfl_lineinfo(found, nullptr, &line, nullptr, nullptr, nullptr);
    }
    return Tree::tuple({Tree::binary(function_at(opened, address)),
                        Tree::binary(file != nullptr ? file : ""), Tree::integer(line)});
}

} // namespace

Tree symbolise(const std::vector<Frame> &frames) {
    std::unordered_map<std::string, OpenModule> modules;
    std::vector<Tree> described;
    for (const Frame &frame : frames) {
        auto known = modules.find(frame.module);
        if (known == modules.end()) {
            known = modules.emplace(frame.module, open_module(frame.module)).first;
        }
        described.push_back(describe(known->second, frame));
    }
    return Tree::list(std::move(described));
}

} // namespace cb
