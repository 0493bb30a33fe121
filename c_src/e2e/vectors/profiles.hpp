// What differs between the profiles' C types, as overloads and one traits struct a profile.
#ifndef E2E_VECTORS_PROFILES_HPP
#define E2E_VECTORS_PROFILES_HPP

#include "E2E_P01.h"
#include "E2E_P02.h"
#include "E2E_P04.h"
#include "E2E_P05.h"
#include "E2E_P06.h"
#include "E2E_P07.h"
#include "E2E_P08.h"
#include "E2E_P11.h"
#include "E2E_P22.h"
#include "E2E_P44.h"
#include "request.hpp"
#include <algorithm>
#include <cstdint>

namespace e2e_vectors {

#define E2E_VECTORS_PROFILE(P)                                                                     \
    struct P {                                                                                     \
        using Config = E2E_##P##ConfigType;                                                        \
        using ProtectState = E2E_##P##ProtectStateType;                                            \
        using CheckState = E2E_##P##CheckStateType;                                                \
        using Status = E2E_##P##CheckStatusType;                                                   \
        static constexpr auto check_config = E2E_##P##CheckConfig;                                 \
        static constexpr auto protect_init = E2E_##P##ProtectInit;                                 \
        static constexpr auto protect = E2E_##P##Protect;                                          \
        static constexpr auto check_init = E2E_##P##CheckInit;                                     \
        static constexpr auto check = E2E_##P##Check;                                              \
        static constexpr auto map_status = E2E_##P##MapStatusToSM;                                 \
    };

E2E_VECTORS_PROFILE(P01)
E2E_VECTORS_PROFILE(P02)
E2E_VECTORS_PROFILE(P04)
E2E_VECTORS_PROFILE(P05)
E2E_VECTORS_PROFILE(P06)
E2E_VECTORS_PROFILE(P07)
E2E_VECTORS_PROFILE(P08)
E2E_VECTORS_PROFILE(P11)
E2E_VECTORS_PROFILE(P22)
E2E_VECTORS_PROFILE(P44)
#undef E2E_VECTORS_PROFILE

// Profiles 1 and 2: no Length argument, NewDataAvailable in the state, a longer check state.
template <class P>
constexpr bool is_early = std::is_same_v<typename P::Config, E2E_P01ConfigType> ||
                          std::is_same_v<typename P::Config, E2E_P02ConfigType>;

template <class C> void read_id_list(const json &from, C &config) {
    std::fill(std::begin(config.DataIDList), std::end(config.DataIDList), std::uint8_t{0});
    const auto list = from.find("DataIDList");
    if (list == from.end()) {
        return;
    }
    if (!list->is_array() || list->size() != std::size(config.DataIDList)) {
        throw BadRequest("member DataIDList must be an array of 16 integers");
    }
    for (std::size_t i = 0; i < list->size(); i++) {
        config.DataIDList[i] = static_cast<std::uint8_t>(number((*list)[i], "DataIDList", 255));
    }
}

template <class C> void read_packet_places(const json &from, C &config) {
    read(from, "CounterOffset", config.CounterOffset);
    read(from, "CRCOffset", config.CRCOffset);
    read(from, "DataID", config.DataID);
    read(from, "DataIDNibbleOffset", config.DataIDNibbleOffset);
    read(from, "DataIDMode", config.DataIDMode);
    read(from, "DataLength", config.DataLength);
}

template <class C> void read_sync_limits(const json &from, C &config) {
    read(from, "MaxDeltaCounterInit", config.MaxDeltaCounterInit);
    read(from, "MaxNoNewOrRepeatedData", config.MaxNoNewOrRepeatedData);
    read(from, "SyncCounterInit", config.SyncCounterInit);
}

// Profiles 4, 6, 7, 8 and 44.
template <class C> void read_config(const json &from, C &config) {
    read(from, "DataID", config.DataID);
    read(from, "Offset", config.Offset);
    read(from, "MinDataLength", config.MinDataLength);
    read(from, "MaxDataLength", config.MaxDataLength);
    read(from, "MaxDeltaCounter", config.MaxDeltaCounter);
}

inline void read_config(const json &from, E2E_P01ConfigType &config) {
    read_packet_places(from, config);
    read_sync_limits(from, config);
}

inline void read_config(const json &from, E2E_P02ConfigType &config) {
    read(from, "DataLength", config.DataLength);
    read_id_list(from, config);
    read_sync_limits(from, config);
    read(from, "Offset", config.Offset);
}

inline void read_config(const json &from, E2E_P05ConfigType &config) {
    read(from, "Offset", config.Offset);
    read(from, "DataLength", config.DataLength);
    read(from, "DataID", config.DataID);
    read(from, "MaxDeltaCounter", config.MaxDeltaCounter);
}

inline void read_config(const json &from, E2E_P11ConfigType &config) {
    read_packet_places(from, config);
    read(from, "MaxDeltaCounter", config.MaxDeltaCounter);
}

inline void read_config(const json &from, E2E_P22ConfigType &config) {
    read(from, "DataLength", config.DataLength);
    read_id_list(from, config);
    read(from, "MaxDeltaCounter", config.MaxDeltaCounter);
    read(from, "Offset", config.Offset);
}

template <class P> void read_check_state(const json &from, typename P::CheckState &state) {
    read(from, "Status", state.Status);
    if constexpr (is_early<P>) {
        read(from, "LastValidCounter", state.LastValidCounter);
        read(from, "MaxDeltaCounter", state.MaxDeltaCounter);
        read(from, "WaitForFirstData", state.WaitForFirstData);
        read(from, "NewDataAvailable", state.NewDataAvailable);
        read(from, "LostData", state.LostData);
        read(from, "SyncCounter", state.SyncCounter);
        read(from, "NoNewOrRepeatedDataCounter", state.NoNewOrRepeatedDataCounter);
    } else {
        read(from, "Counter", state.Counter);
    }
}

template <class P> json write_check_state(const typename P::CheckState &state) {
    if constexpr (is_early<P>) {
        return {{"LastValidCounter", state.LastValidCounter},
                {"MaxDeltaCounter", state.MaxDeltaCounter},
                {"WaitForFirstData", state.WaitForFirstData != 0},
                {"NewDataAvailable", state.NewDataAvailable != 0},
                {"LostData", state.LostData},
                {"Status", static_cast<int>(state.Status)},
                {"SyncCounter", state.SyncCounter},
                {"NoNewOrRepeatedDataCounter", state.NoNewOrRepeatedDataCounter}};
    } else {
        return {{"Counter", state.Counter}, {"Status", static_cast<int>(state.Status)}};
    }
}

// The bytes that profiles 1 and 2 will touch; they trust the caller to provide them.
inline std::size_t bytes_needed(const E2E_P01ConfigType &config) {
    std::size_t bytes = config.DataLength / 8U;
    bytes = std::max<std::size_t>(bytes, config.CRCOffset / 8U + 1U);
    bytes = std::max<std::size_t>(bytes, config.CounterOffset / 8U + 1U);
    if (config.DataIDMode == E2E_P01_DATAID_NIBBLE) {
        bytes = std::max<std::size_t>(bytes, config.DataIDNibbleOffset / 8U + 1U);
    }
    return bytes;
}

inline std::size_t bytes_needed(const E2E_P02ConfigType &config) {
    return config.DataLength / 8U;
}

} // namespace e2e_vectors

#endif
