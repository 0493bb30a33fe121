// Structs and unions by value follow the classification of the System V x86-64 ABI, section 3.2.3:
// up to 16 bytes are passed as one or two "eightbytes", each of class INTEGER or SSE; everything
// else goes through memory. libffi has no unions and no bit-fields, so it is given the eightbytes
// themselves.
#include "ffi_types.hpp"

#include <algorithm>

namespace cb {

namespace {

#if !defined(__x86_64__)
#error                                                                                             \
    "passing structs by value is written for x86-64; other processors need their own classification here"
#endif

enum class Class { None, Sse, Integer };

struct Layout {
    Class eightbytes[2] = {Class::None, Class::None};
    std::uint64_t end = 0;
    unsigned alignment = 1;
    bool aligned = true; // each member at a multiple of its alignment
    bool long_double = false;
    bool supported = true;
};

void add_scalar(Layout &layout, std::uint64_t bit_offset, const Type &type) {
    const std::uint64_t offset = bit_offset / 8;
    layout.aligned = layout.aligned && bit_offset % (8 * type.size) == 0;
    layout.alignment = std::max(layout.alignment, static_cast<unsigned>(type.size));
    layout.end = std::max(layout.end, offset + type.size);
    layout.long_double = layout.long_double || (type.kind == Kind::Float && type.size > 8);
    if (offset < 16) {
        Class &known = layout.eightbytes[offset / 8];
        const Class own = type.kind == Kind::Float ? Class::Sse : Class::Integer;
        known = std::max(known, own);
    }
}

void add_bits(Layout &layout, std::uint64_t bit_offset, unsigned bits, const Type &type) {
    const std::uint64_t last = bit_offset + bits - 1;
    layout.alignment = std::max(layout.alignment, static_cast<unsigned>(type.size));
    layout.end = std::max(layout.end, last / 8 + 1);
    // The unit a bit-field is declared with must hold all of it; a packed one may straddle.
    layout.aligned = layout.aligned && bit_offset / (8 * type.size) == last / (8 * type.size);
    for (const std::uint64_t bit : {bit_offset, last}) {
        if (bit < 128) {
            layout.eightbytes[bit / 64] = Class::Integer;
        }
    }
}

void add(Layout &layout, std::uint64_t bit_offset, const Type &type) {
    if (type.is_scalar()) {
        return add_scalar(layout, bit_offset, type);
    }
    switch (type.kind) {
    case Kind::Array: {
        const Type &element = type.target();
        // Beyond 16 bytes only alignment and the end count, and the last element shows both.
        const std::uint64_t shown = std::min<std::uint64_t>(type.count, 16);
        for (std::uint64_t i = 0; i < shown; ++i) {
            add(layout, bit_offset + 8 * i * element.size, element);
        }
        layout.end = std::max(layout.end, bit_offset / 8 + type.size);
        return;
    }
    case Kind::Struct:
    case Kind::Union:
        layout.supported = layout.supported && !type.passed_by_reference && !type.members.empty();
        for (const Member &member : type.members) {
            if (member.bit_size != 0) {
                add_bits(layout, bit_offset + member.bit_offset, member.bit_size, *member.type);
            } else {
                add(layout, bit_offset + member.bit_offset, *member.type);
            }
        }
        return;
    default:
        layout.supported = false;
    }
}

bool passable(const Layout &layout, const Type &type) {
    const std::uint64_t natural =
        (layout.end + layout.alignment - 1) / layout.alignment * layout.alignment;
    const bool mixed_long_double = layout.long_double && type.size <= 16 &&
                                   (type.kind == Kind::Union || type.members.size() != 1);
    return layout.supported && layout.aligned && natural == type.size && !mixed_long_double;
}

// Elements that libffi classifies as this eightbyte. Sizes other than 4 and 8 matter only for
// INTEGER.
ffi_type *eightbyte(Class kind, std::uint64_t bytes) {
    if (kind == Class::Sse) {
        return bytes > 4 ? &ffi_type_double : &ffi_type_float;
    }
    return bytes > 4   ? &ffi_type_uint64
           : bytes > 2 ? &ffi_type_uint32
           : bytes > 1 ? &ffi_type_uint16
                       : &ffi_type_uint8;
}

ffi_type *scalar(const Type &type) {
    if (type.kind == Kind::Pointer) {
        return &ffi_type_pointer;
    }
    if (type.kind == Kind::Float) {
        return type.size == sizeof(float)    ? &ffi_type_float
               : type.size == sizeof(double) ? &ffi_type_double
                                             : &ffi_type_longdouble;
    }
    const bool is_signed = type.kind == Kind::Signed || (type.kind == Kind::Enum && type.is_signed);
    switch (type.size) {
    case 1:
        return is_signed ? &ffi_type_sint8 : &ffi_type_uint8;
    case 2:
        return is_signed ? &ffi_type_sint16 : &ffi_type_uint16;
    case 4:
        return is_signed ? &ffi_type_sint32 : &ffi_type_uint32;
    case 8:
        return is_signed ? &ffi_type_sint64 : &ffi_type_uint64;
    default:
        return nullptr;
    }
}

} // namespace

ffi_type *FfiTypes::of(const Type &type) {
    if (type.is_scalar()) {
        return scalar(type);
    }
    if (type.kind == Kind::Void) {
        return &ffi_type_void;
    }
    if (type.kind != Kind::Struct && type.kind != Kind::Union) {
        return nullptr;
    }
    const auto known = known_.find(&type);
    if (known != known_.end()) {
        return known->second;
    }
    return known_[&type] = composite(type);
}

ffi_type *FfiTypes::composite(const Type &type) {
    Layout layout;
    add(layout, 0, type);
    if (!passable(layout, type)) {
        return nullptr;
    }
    Composite &made = composites_.emplace_back();
    if (layout.long_double && type.size == 16) {
        made.elements = {&ffi_type_longdouble};
    } else if (type.size > 16) {
        made.elements = {&ffi_type_uint64}; // any size above 16 with an INTEGER start is MEMORY
    } else {
        made.elements.push_back(
            eightbyte(layout.eightbytes[0], std::min<std::uint64_t>(type.size, 8)));
        if (type.size > 8) {
            made.elements.push_back(eightbyte(layout.eightbytes[1], type.size - 8));
        }
    }
    made.elements.push_back(nullptr);
    made.type.type = FFI_TYPE_STRUCT;
    // A size that is set already keeps libffi from computing its own from the elements.
    made.type.size = type.size;
    made.type.alignment = static_cast<unsigned short>(layout.alignment);
    made.type.elements = made.elements.data();
    return &made.type;
}

} // namespace cb
