#include "function.hpp"

#include "error.hpp"
#include "names.hpp"

#include <cxxabi.h>

#include <algorithm>
#include <cstring>
#include <typeinfo>

namespace cb {

namespace {

constexpr std::size_t kSlot = 16; // of the widest scalar, long double

[[noreturn]] void unsupported(const Name &name, std::size_t position, const Type &type) {
    fail("not_callable", Tree::atom(name.text()),
         Tree::tuple({Tree::atom("unsupported_type"),
                      Tree::integer(static_cast<std::int64_t>(position)),
                      Tree::atom(type.spelling.text())}));
}

std::string exception_text() {
    int status = 0;
    const std::type_info *type = abi::__cxa_current_exception_type();
    char *readable =
        type != nullptr ? abi::__cxa_demangle(type->name(), nullptr, nullptr, &status) : nullptr;
    const std::string text = readable != nullptr ? readable : "unknown";
    std::free(readable);
    return text;
}

// A function called through libffi may throw; what it throws must end here.
void guarded_call(ffi_cif &cif, void *address, void *result, void **slots) {
    try {
        ffi_call(&cif, FFI_FN(address), result, slots);
    } catch (const Error &) { // of a callback stub
        throw;
    } catch (const std::exception &exception) {
        fail("cxx_exception", Tree::binary(exception_text() + ": " + exception.what()));
    } catch (const abi::__forced_unwind &) { // a thread that ends itself
        throw;
    } catch (...) {
        fail("cxx_exception", Tree::binary(exception_text()));
    }
}

} // namespace

Function::Function(std::string name, Prototype prototype, FfiTypes &ffi)
    : name_(std::move(name)), prototype_(std::move(prototype)) {
    ffi_result_ = ffi.of(*prototype_.result);
    if (ffi_result_ == nullptr) {
        unsupported(name_, 0, *prototype_.result);
    }
    for (std::size_t i = 0; i < prototype_.parameters.size(); ++i) {
        const Type &type = *prototype_.parameters[i].type;
        const bool promoted =
            prototype_.promotes_floats && type.kind == Kind::Float && type.size == 4;
        ffi_type *known = type.kind == Kind::Void ? nullptr : ffi.of(type);
        if (known == nullptr) {
            unsupported(name_, i + 1, type);
        }
        ffi_parameters_.push_back(promoted ? &ffi_type_double : known);
        offsets_.push_back(frame_);
        frame_ += static_cast<std::uint32_t>((type.size + kSlot - 1) / kSlot * kSlot);
    }
    // libffi widens small integers to a register, and may write whole registers of a struct.
    const std::size_t room = std::max<std::size_t>(prototype_.result->size, 2 * sizeof(ffi_arg));
    result_room_ = static_cast<std::uint32_t>((room + kSlot - 1) / kSlot * kSlot);
    ffi_prep_cif(&cif_, FFI_DEFAULT_ABI, static_cast<unsigned>(ffi_parameters_.size()), ffi_result_,
                 ffi_parameters_.data());
}

void Function::check_arity(std::uint32_t given) const {
    const std::size_t fixed = prototype_.parameters.size();
    const bool open = prototype_.variadic || prototype_.any_arguments;
    if (given == fixed || (open && given > fixed)) {
        return;
    }
    const Tree count = Tree::integer(static_cast<std::int64_t>(fixed));
    fail("arity", Tree::atom(name_.text()),
         open ? Tree::tuple({Tree::atom("at_least"), count}) : count, Tree::integer(given),
         Tree::binary(prototype_.text(name_.text())));
}

namespace {

[[noreturn]] void bad_argument(const Name &function, std::size_t position, const std::string &name,
                               const Tree &detail) {
    fail("arg", Tree::atom(function.text()), Tree::integer(static_cast<std::int64_t>(position) + 1),
         Tree::atom(name), detail);
}

} // namespace

void Function::read_argument(ConversionContext &context, TermReader &reader, Term term,
                             std::size_t position, unsigned char *place, Arena &arena) {
    const Parameter &parameter = prototype_.parameters[position];
    try {
        value_in(context, reader, term, *parameter.type, place, arena);
    } catch (const ValueError &error) {
        bad_argument(name_, position, parameter.name.text(), error.detail());
    }
    if (prototype_.promotes_floats && parameter.type->kind == Kind::Float &&
        parameter.type->size == sizeof(float)) {
        float narrow = 0;
        std::memcpy(&narrow, place, sizeof narrow);
        const auto wide = static_cast<double>(narrow);
        std::memcpy(place, &wide, sizeof wide);
    }
}

void Function::call(ConversionContext &context, TermReader &reader, Term arguments,
                    TermWriter &writer, Arena &arena) {
    ListCursor cursor;
    if (!reader.read_list(arguments, cursor)) {
        fail("bad_request", Tree::foreign(reader, arguments));
    }
    check_arity(cursor.left);
    arena.clear();
    const std::size_t count = prototype_.parameters.size();
    if (cursor.left > count || prototype_.variadic) {
        return call_variadic(context, reader, cursor, writer, arena);
    }
    auto *frame = static_cast<unsigned char *>(
        arena.take_raw(frame_ + result_room_ + count * sizeof(void *)));
    unsigned char *result = frame + frame_;
    void **slots = reinterpret_cast<void **>(result + result_room_);
    for (std::size_t i = 0; i < count; ++i) {
        slots[i] = frame + offsets_[i];
        read_argument(context, reader, reader.next(cursor), i, frame + offsets_[i], arena);
    }
    guarded_call(cif_, address, result, slots);
    value_out(context, writer, *prototype_.result, result);
}

namespace {

// An argument without a declared type: what C's default promotions make of it. Integers go as 64
// bits; a function that takes an int reads the lower half.
ffi_type *free_argument(ConversionContext &context, TermReader &reader, Term term,
                        unsigned char *place, Arena &arena) {
    std::int64_t integer = 0;
    std::uint64_t wide = 0;
    double number = 0;
    std::string_view text;
    if (reader.read_signed(term, integer)) {
        std::memcpy(place, &integer, sizeof integer);
        return &ffi_type_sint64;
    }
    if (reader.read_unsigned(term, wide)) {
        std::memcpy(place, &wide, sizeof wide);
        return &ffi_type_uint64;
    }
    if (reader.read_float(term, number)) {
        std::memcpy(place, &number, sizeof number);
        return &ffi_type_double;
    }
    void *address = nullptr;
    if (reader.read_binary(term, text)) {
        address = arena.take(text.size() + 1);
        std::memcpy(address, text.data(), text.size());
    } else if (looks_like_pointer(reader, term)) {
        address = read_pointer(context, reader, term).address;
    } else {
        throw ValueError(
            Tree::tuple({Tree::atom("bad_type"), Tree::atom("..."), Tree::foreign(reader, term)}));
    }
    std::memcpy(place, &address, sizeof address);
    return &ffi_type_pointer;
}

} // namespace

void Function::call_variadic(ConversionContext &context, TermReader &reader, ListCursor arguments,
                             TermWriter &writer, Arena &arena) {
    const std::size_t fixed = prototype_.parameters.size();
    const std::uint32_t given = arguments.left;
    auto *frame = static_cast<unsigned char *>(arena.take(frame_ + (given - fixed) * kSlot));
    std::vector<void *> slots(given);
    std::vector<ffi_type *> types = ffi_parameters_;
    for (std::size_t i = 0; i < given; ++i) {
        const Term term = reader.next(arguments);
        slots[i] = i < fixed ? frame + offsets_[i] : frame + frame_ + (i - fixed) * kSlot;
        auto *place = static_cast<unsigned char *>(slots[i]);
        if (i < fixed) {
            read_argument(context, reader, term, i, place, arena);
            continue;
        }
        try {
            types.push_back(free_argument(context, reader, term, place, arena));
        } catch (const ValueError &error) {
            bad_argument(name_, i, "...", error.detail());
        }
    }
    ffi_cif cif;
    if (prototype_.variadic) {
        ffi_prep_cif_var(&cif, FFI_DEFAULT_ABI, static_cast<unsigned>(fixed), given, ffi_result_,
                         types.data());
    } else {
        ffi_prep_cif(&cif, FFI_DEFAULT_ABI, given, ffi_result_, types.data());
    }
    void *result = arena.take_raw(result_room_);
    guarded_call(cif, address, result, slots.data());
    value_out(context, writer, *prototype_.result, result);
}

} // namespace cb
