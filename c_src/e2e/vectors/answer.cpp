#include "answer.hpp"
#include "Crc.h"
#include "E2E_SM.h"
#include "profiles.hpp"

namespace e2e_vectors {

namespace {

template <class T>
json crc_reply(T (*calculate)(const uint8 *, uint32, T, boolean), const json &request) {
    constexpr int digits = 2 * sizeof(T);
    const Bytes data = from_hex(text(request, "data"), "data");
    const auto first = request.find("first");
    if (first == request.end() || !first->is_boolean()) {
        throw BadRequest("member first must be true or false");
    }
    T start = 0;
    if (!first->get<bool>()) {
        const Bytes bytes = from_hex(text(request, "start"), "start");
        if (bytes.size() != sizeof(T)) {
            throw BadRequest("member start must have " + std::to_string(digits) + " hex digits");
        }
        for (const std::uint8_t byte : bytes) {
            start = static_cast<T>(static_cast<std::uint64_t>(start) << 8 | byte);
        }
    }
    const T crc = calculate(data.data(), static_cast<uint32>(data.size()), start,
                            first->get<bool>() ? TRUE : FALSE);
    return {{"crc", to_hex(crc, digits)}};
}

json crc(const json &request) {
    const std::string algo = text(request, "algo");
    if (algo == "CRC8")
        return crc_reply(Crc_CalculateCRC8, request);
    if (algo == "CRC8H2F")
        return crc_reply(Crc_CalculateCRC8H2F, request);
    if (algo == "CRC16")
        return crc_reply(Crc_CalculateCRC16, request);
    if (algo == "CRC16ARC")
        return crc_reply(Crc_CalculateCRC16ARC, request);
    if (algo == "CRC32")
        return crc_reply(Crc_CalculateCRC32, request);
    if (algo == "CRC32P4")
        return crc_reply(Crc_CalculateCRC32P4, request);
    if (algo == "CRC64")
        return crc_reply(Crc_CalculateCRC64, request);
    throw Unsupported{};
}

template <class P> typename P::Config config_of(const json &request) {
    typename P::Config config{};
    read_config(object(request, "config"), config);
    return config;
}

template <class T> T *unless_null(const json &request, const char *name, T *pointer) {
    return is_null(request, name) ? nullptr : pointer;
}

// What the library gets as Data: exactly the bytes of the request, and never NULL by accident.
struct Buffer {
    Bytes bytes;
    uint8 none = 0;
    uint8 *data() {
        return bytes.empty() ? &none : bytes.data();
    }
};

template <class P> void require_room(const json &request, const Buffer &buffer) {
    if constexpr (is_early<P>) {
        const std::size_t needed = bytes_needed(config_of<P>(request));
        if (!is_null(request, "config") && buffer.bytes.size() < needed) {
            throw BadRequest("data is " + std::to_string(buffer.bytes.size()) +
                             " bytes, the configuration needs " + std::to_string(needed));
        }
    }
}

// Calls protect or check with the arguments its profile takes.
template <class P, class F, class C, class S, class D>
Std_ReturnType call(F function, const C *config, S *state, D *data, std::size_t length) {
    if constexpr (is_early<P>) {
        return function(config, state, data);
    } else if constexpr (std::is_invocable_v<F, const C *, S *, D *, uint32> &&
                         (std::is_same_v<P, P07> || std::is_same_v<P, P08>)) {
        return function(config, state, data, static_cast<uint32>(length));
    } else {
        if (length > 0xFFFF) {
            throw BadRequest("data is " + std::to_string(length) +
                             " bytes, the profile takes at most 65535");
        }
        return function(config, state, data, static_cast<uint16>(length));
    }
}

template <class P> json check_config(const json &request) {
    const auto config = config_of<P>(request);
    return {{"ret", P::check_config(unless_null(request, "config", &config))}};
}

template <class P> json protect_init(const json &request) {
    typename P::ProtectState state{};
    const auto ret = P::protect_init(unless_null(request, "state", &state));
    return {{"ret", ret}, {"state", {{"Counter", state.Counter}}}};
}

template <class P> json check_init(const json &request) {
    typename P::CheckState state{};
    const auto ret = P::check_init(unless_null(request, "state", &state));
    return {{"ret", ret}, {"state", write_check_state<P>(state)}};
}

template <class P> json protect(const json &request) {
    const auto config = config_of<P>(request);
    typename P::ProtectState state{};
    read(object(request, "state"), "Counter", state.Counter);
    Buffer buffer{from_hex(text(request, "data"), "data")};
    require_room<P>(request, buffer);
    const auto ret = call<P>(P::protect, unless_null(request, "config", &config),
                             unless_null(request, "state", &state),
                             unless_null(request, "data", buffer.data()), buffer.bytes.size());
    return {{"ret", ret}, {"data", to_hex(buffer.bytes)}, {"state", {{"Counter", state.Counter}}}};
}

template <class P> json check(const json &request) {
    const auto config = config_of<P>(request);
    typename P::CheckState state{};
    read_check_state<P>(object(request, "state"), state);
    const auto data = request.find("data");
    const bool nothing = data == request.end() || data->is_null();
    Buffer buffer{};
    const uint8 *pointer = nullptr;
    if (!nothing) {
        buffer.bytes = from_hex(text(request, "data"), "data");
        require_room<P>(request, buffer);
        pointer = buffer.data();
    } else if constexpr (is_early<P>) {
        buffer.bytes.resize(bytes_needed(config));
        pointer = buffer.data();
    }
    if constexpr (is_early<P>) {
        state.NewDataAvailable = nothing ? FALSE : TRUE;
    }
    const auto ret = call<P>(P::check, unless_null(request, "config", &config),
                             unless_null(request, "state", &state),
                             unless_null(request, "data", pointer), buffer.bytes.size());
    return {{"ret", ret}, {"state", write_check_state<P>(state)}};
}

template <class P> json map_status(const json &request) {
    uint8 check_ret = 0;
    typename P::Status status{};
    read(request, "check_ret", check_ret);
    read(request, "status", status);
    if constexpr (is_early<P>) {
        boolean behavior = FALSE;
        read(request, "profile_behavior", behavior);
        return {{"result", static_cast<int>(P::map_status(check_ret, status, behavior))}};
    } else {
        return {{"result", static_cast<int>(P::map_status(check_ret, status))}};
    }
}

template <class P> json profile_op(const std::string &op, const json &request) {
    if (op == "protect_init")
        return protect_init<P>(request);
    if (op == "check_init")
        return check_init<P>(request);
    if (op == "protect")
        return protect<P>(request);
    if (op == "check")
        return check<P>(request);
    if (op == "map")
        return map_status<P>(request);
    if (op == "check_config")
        return check_config<P>(request);
    throw Unsupported{};
}

json profile_request(const std::string &op, const json &request) {
    const std::string profile = text(request, "profile");
    if (profile == "P01")
        return profile_op<P01>(op, request);
    if (profile == "P02")
        return profile_op<P02>(op, request);
    if (profile == "P04")
        return profile_op<P04>(op, request);
    if (profile == "P05")
        return profile_op<P05>(op, request);
    if (profile == "P06")
        return profile_op<P06>(op, request);
    if (profile == "P07")
        return profile_op<P07>(op, request);
    if (profile == "P08")
        return profile_op<P08>(op, request);
    if (profile == "P11")
        return profile_op<P11>(op, request);
    if (profile == "P22")
        return profile_op<P22>(op, request);
    if (profile == "P44")
        return profile_op<P44>(op, request);
    throw Unsupported{};
}

E2E_SMConfigType sm_config(const json &request) {
    const json &from = object(request, "config");
    E2E_SMConfigType config{};
    read(from, "WindowSizeValid", config.WindowSizeValid);
    read(from, "WindowSizeInit", config.WindowSizeInit);
    read(from, "WindowSizeInvalid", config.WindowSizeInvalid);
    read(from, "MinOkStateInit", config.MinOkStateInit);
    read(from, "MaxErrorStateInit", config.MaxErrorStateInit);
    read(from, "MinOkStateValid", config.MinOkStateValid);
    read(from, "MaxErrorStateValid", config.MaxErrorStateValid);
    read(from, "MinOkStateInvalid", config.MinOkStateInvalid);
    read(from, "MaxErrorStateInvalid", config.MaxErrorStateInvalid);
    read(from, "ClearToInvalid", config.ClearToInvalid);
    return config;
}

Bytes sm_window(const json &from, std::size_t size) {
    const auto list = from.find("ProfileStatusWindow");
    if (list == from.end() || !list->is_array() || list->size() != size) {
        throw BadRequest("member ProfileStatusWindow must be an array of WindowSizeValid (" +
                         std::to_string(size) + ") integers");
    }
    Bytes window;
    for (const json &entry : *list) {
        window.push_back(static_cast<std::uint8_t>(number(entry, "ProfileStatusWindow", 255)));
    }
    return window;
}

json sm_reply(Std_ReturnType ret, const E2E_SMCheckStateType &state, const Bytes &window) {
    return {{"ret", ret},
            {"state",
             {{"ProfileStatusWindow", window},
              {"WindowTopIndex", state.WindowTopIndex},
              {"OkCount", state.OkCount},
              {"ErrorCount", state.ErrorCount},
              {"SMState", static_cast<int>(state.SMState)}}}};
}

json sm_init(const json &request) {
    const E2E_SMConfigType config = sm_config(request);
    Buffer window{Bytes(config.WindowSizeValid)};
    E2E_SMCheckStateType state{};
    state.ProfileStatusWindow = window.data();
    const auto ret = E2E_SMCheckInit(unless_null(request, "state", &state),
                                     unless_null(request, "config", &config));
    return sm_reply(ret, state, window.bytes);
}

json sm(const json &request) {
    const E2E_SMConfigType config = sm_config(request);
    const json &from = object(request, "state");
    Buffer window{sm_window(from, config.WindowSizeValid)};
    E2E_SMCheckStateType state{};
    state.ProfileStatusWindow = window.data();
    read(from, "WindowTopIndex", state.WindowTopIndex);
    read(from, "OkCount", state.OkCount);
    read(from, "ErrorCount", state.ErrorCount);
    read(from, "SMState", state.SMState);
    E2E_PCheckStatusType status{};
    read(request, "status", status);
    const auto ret = E2E_SMCheck(status, unless_null(request, "config", &config),
                                 unless_null(request, "state", &state));
    return sm_reply(ret, state, window.bytes);
}

json sm_check_config(const json &request) {
    const E2E_SMConfigType config = sm_config(request);
    return {{"ret", E2E_SMCheckConfig(unless_null(request, "config", &config))}};
}

json dispatch(const json &request) {
    if (!request.is_object()) {
        throw BadRequest("the line is not a JSON object");
    }
    const std::string op = text(request, "op");
    if (op == "crc")
        return crc(request);
    if (op == "sm_init")
        return sm_init(request);
    if (op == "sm")
        return sm(request);
    if (op == "sm_check_config")
        return sm_check_config(request);
    for (const char *known :
         {"protect_init", "check_init", "protect", "check", "map", "check_config"}) {
        if (op == known)
            return profile_request(op, request);
    }
    throw Unsupported{};
}

json reply(const std::string &line) {
    try {
        return dispatch(json::parse(line));
    } catch (const Unsupported &) {
        return {{"unsupported", true}};
    } catch (const json::parse_error &error) {
        return {{"error", "not JSON, at byte " + std::to_string(error.byte)}};
    } catch (const BadRequest &error) {
        return {{"error", error.what()}};
    }
}

} // namespace

std::string answer(const std::string &line) {
    return reply(line).dump();
}

} // namespace e2e_vectors
