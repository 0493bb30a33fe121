// One C function, ready to be called.
#pragma once

#include "arena.hpp"
#include "convert.hpp"
#include "ffi_types.hpp"
#include "type.hpp"

#include <cstdint>
#include <ffi.h>

#include <optional>
#include <string>
#include <vector>

namespace cb {

// What a prototype says, from a subprogram or a subroutine type.
struct Prototype {
    std::vector<Parameter> parameters;
    const Type *result = nullptr;
    bool variadic = false;
    bool any_arguments = false;   // `int f()` in C before C23
    bool promotes_floats = false; // old-style definition: float parameters arrive as double
    std::string text(const std::string &name) const;
};

Prototype read_prototype(Dwarf_Die &die, TypeTable &types);

class Function {
  public:
    // Throws Error {not_callable, F, {unsupported_type, Pos, CType}}; position 0 is the result.
    Function(std::string name, Prototype prototype, FfiTypes &ffi);
    Function(const Function &) = delete;
    Function &operator=(const Function &) = delete;

    const Name &name() const {
        return name_;
    }
    const Prototype &prototype() const {
        return prototype_;
    }

    // Reads the arguments, calls, writes the result. Throws Error; a C++ exception of the function
    // becomes one.
    void call(ConversionContext &context, TermReader &reader, Term arguments, TermWriter &writer,
              Arena &arena);

    void *address = nullptr; // changes when the library is loaded afresh

  private:
    void check_arity(std::uint32_t given) const;
    void read_argument(ConversionContext &context, TermReader &reader, Term term,
                       std::size_t position, unsigned char *place, Arena &arena);
    void call_variadic(ConversionContext &context, TermReader &reader, ListCursor arguments,
                       TermWriter &writer, Arena &arena);

    Name name_;
    Prototype prototype_;
    std::vector<ffi_type *> ffi_parameters_;
    ffi_type *ffi_result_ = nullptr;
    ffi_cif cif_{};
    std::vector<std::uint32_t> offsets_; // of each argument in the frame
    std::uint32_t frame_ = 0;
    std::uint32_t result_room_ = 0;
};

} // namespace cb
