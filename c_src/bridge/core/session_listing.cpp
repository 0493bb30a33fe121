// What a session offers: lists of functions and variables.
#include "session.hpp"

#include "error.hpp"

#include <unordered_set>

namespace cb {

namespace {

// Linkage names of the C++ run-time library: instances of its templates are in every C++ program.
bool is_runtime_function(std::string_view name) {
    for (const std::string_view prefix : {"_ZNSt", "_ZSt", "_ZNKSt", "_ZN9__gnu", "_ZNK9__gnu"}) {
        if (name.substr(0, prefix.size()) == prefix) {
            return true;
        }
    }
    return false;
}

Tree describe(std::string_view name, const Prototype &prototype) {
    std::vector<Tree> parameters;
    for (const Parameter &parameter : prototype.parameters) {
        parameters.push_back(Tree::tuple(
            {Tree::atom(parameter.name.text()), Tree::atom(parameter.type->spelling.text())}));
    }
    return Tree::tuple({Tree::atom(std::string(name)), Tree::list(std::move(parameters)),
                        Tree::atom(prototype.result->spelling.text())});
}

} // namespace

// Each function once: by its plain name, or by its linkage name if overloads share the plain one.
Tree Session::functions() {
    std::vector<Tree> listed;
    std::unordered_set<std::string_view> names;
    std::unordered_set<void *> addresses;
    const auto list = [&](std::string_view name) {
        try {
            const Function &found = function(std::string(name));
            if (addresses.insert(found.address).second || name.substr(0, 2) != "_Z") {
                listed.push_back(describe(name, found.prototype()));
            }
        } catch (const Error &) { // cannot be called: not in the list
        }
    };
    for (const bool linkage : {false, true}) {
        for (const Part &part : parts_) {
            if (part.info == nullptr) {
                continue;
            }
            part.info->each_function([&](std::string_view name, Dwarf_Die &) {
                const bool is_linkage = name.substr(0, 2) == "_Z";
                if (is_linkage == linkage && !is_runtime_function(name) &&
                    names.insert(name).second) {
                    list(name);
                }
            });
        }
    }
    if (signatures_ != nullptr) {
        signatures_->each_variable([&](std::string_view name, Dwarf_Die &) {
            if (name.substr(0, kSignaturePrefix.size()) == kSignaturePrefix) {
                list(name.substr(kSignaturePrefix.size()));
            }
        });
    }
    return Tree::list(std::move(listed));
}

Tree Session::globals() {
    std::vector<Tree> listed;
    std::unordered_set<std::string_view> names;
    const auto list = [&](std::string_view name) {
        if (name.substr(0, 2) == "_Z" || !names.insert(name).second) {
            return;
        }
        try {
            if (const KnownVariable *variable = find_variable(std::string(name))) {
                listed.push_back(Tree::tuple(
                    {Tree::atom(std::string(name)), Tree::atom(variable->type->spelling.text())}));
            }
        } catch (const Error &) { // has no place in memory: not in the list
        }
    };
    for (const Part &part : parts_) {
        if (part.info != nullptr) {
            part.info->each_variable([&](std::string_view name, Dwarf_Die &) { list(name); });
        }
    }
    if (signatures_ != nullptr) {
        signatures_->each_variable([&](std::string_view name, Dwarf_Die &) {
            if (name.substr(0, kSignaturePrefix.size()) == kSignaturePrefix) {
                list(name.substr(kSignaturePrefix.size()));
            }
        });
    }
    return Tree::list(std::move(listed));
}

} // namespace cb
