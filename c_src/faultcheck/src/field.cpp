#include "field.h"

#include <algorithm>

namespace fc {

namespace {

bool has_field(const fc_field &field, std::size_t size, std::size_t packet_size) {
    return field.offset <= packet_size && size <= packet_size - field.offset;
}

constexpr bool kHostIsBig = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;

template <class T> int apply_as(const FaultCall &call, const fc_field &field, std::string *packet) {
    unsigned char bytes[sizeof(T)];
    if (!has_field(field, sizeof bytes, packet->size()))
        return FC_E_INDEX;
    std::memcpy(bytes, packet->data() + field.offset, sizeof bytes);
    if (field.big_endian != kHostIsBig)
        std::reverse(bytes, bytes + sizeof bytes);
    T value;
    if constexpr (std::is_same_v<T, bool>)
        value = bytes[0] != 0; // any other byte is not a bool
    else
        std::memcpy(&value, bytes, sizeof value);
    const int code = apply(call, &value);
    if (code != FC_OK)
        return code;
    std::memcpy(bytes, &value, sizeof bytes);
    if (field.big_endian != kHostIsBig)
        std::reverse(bytes, bytes + sizeof bytes);
    std::memcpy(&(*packet)[field.offset], bytes, sizeof bytes);
    return FC_OK;
}

int apply_as_bytes(const FaultCall &call, const fc_field &field, std::string *packet) {
    if (!has_field(field, field.length, packet->size()))
        return FC_E_INDEX;
    ByteSpan bytes{reinterpret_cast<unsigned char *>(&(*packet)[0]) + field.offset,
                   field.length != 0 ? field.length : packet->size() - field.offset};
    return apply(call, &bytes);
}

} // namespace

int apply_to_field(const FaultCall &call, const fc_field &field, std::string *packet) {
    switch (field.type) {
    case FC_F32:
        return apply_as<float>(call, field, packet);
    case FC_F64:
        return apply_as<double>(call, field, packet);
    case FC_I8:
        return apply_as<std::int8_t>(call, field, packet);
    case FC_I16:
        return apply_as<std::int16_t>(call, field, packet);
    case FC_I32:
        return apply_as<std::int32_t>(call, field, packet);
    case FC_I64:
        return apply_as<std::int64_t>(call, field, packet);
    case FC_U8:
        return apply_as<std::uint8_t>(call, field, packet);
    case FC_U16:
        return apply_as<std::uint16_t>(call, field, packet);
    case FC_U32:
        return apply_as<std::uint32_t>(call, field, packet);
    case FC_U64:
        return apply_as<std::uint64_t>(call, field, packet);
    case FC_BOOL:
        return apply_as<bool>(call, field, packet);
    case FC_BYTES:
        return apply_as_bytes(call, field, packet);
    }
    return FC_E_TYPE;
}

} // namespace fc
