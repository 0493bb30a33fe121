// Fuzz target: any configuration, any state and any packet into the Check of every profile, then
// what was protected into it as well, and any verdicts into the state machine.
//
// Beyond what the sanitizers see, each run asserts that a refused call changes nothing and that a
// receiver one step behind accepts what Protect wrote. Packets lie in heap blocks of exactly their
// size.
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
#include "E2E_SM.h"
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <memory>
#include <type_traits>

namespace {

void require(bool good) {
    if (!good) {
        std::abort();
    }
}

// Longer inputs reach nothing new and take longer.
constexpr std::size_t longest = 200;

// The input, read from its front; zeros after its end.
struct Input {
    const std::uint8_t *at;
    std::size_t left;
    std::uint32_t number(int bytes) {
        std::uint32_t value = 0;
        for (; bytes > 0; bytes--) {
            value = value << 8 | (left > 0 ? *at : 0U);
            at += left > 0;
            left -= left > 0;
        }
        return value;
    }
    template <class T> void into(T &member, std::uint64_t limit = ~0ULL) {
        member = static_cast<T>(number(sizeof(T)) % limit);
    }
};

// Places reach a little beyond the longest packet an input can hold, so that they often fit.
constexpr std::uint64_t places = 8U * 64U;

template <class C> void fill_packet(Input &in, C &config) {
    in.into(config.CounterOffset, 256);
    in.into(config.CRCOffset, 256);
    in.into(config.DataID);
    in.into(config.DataIDNibbleOffset, 256);
    in.into(config.DataLength, 264);
}
template <class C> void fill_list(Input &in, C &config) {
    for (uint8 &id : config.DataIDList) {
        in.into(id);
    }
}
template <class C> void fill_sync(Input &in, C &config) {
    in.into(config.MaxDeltaCounterInit);
    in.into(config.MaxNoNewOrRepeatedData);
    in.into(config.SyncCounterInit);
}
void fill(Input &in, E2E_P01ConfigType &config) {
    fill_packet(in, config);
    config.DataIDMode = static_cast<E2E_P01DataIDMode>(in.number(1) % 4);
    fill_sync(in, config);
}
void fill(Input &in, E2E_P02ConfigType &config) {
    in.into(config.DataLength, places);
    fill_list(in, config);
    fill_sync(in, config);
    in.into(config.Offset, places);
}
void fill(Input &in, E2E_P05ConfigType &config) {
    in.into(config.Offset, places);
    in.into(config.DataID);
    in.into(config.MaxDeltaCounter);
}
void fill(Input &in, E2E_P11ConfigType &config) {
    fill_packet(in, config);
    config.DataIDMode = in.number(1) % 2 != 0 ? E2E_P11_DATAID_NIBBLE : E2E_P11_DATAID_BOTH;
    in.into(config.MaxDeltaCounter);
}
void fill(Input &in, E2E_P22ConfigType &config) {
    fill_list(in, config);
    in.into(config.MaxDeltaCounter);
    in.into(config.Offset, places);
}
template <class C> void fill(Input &in, C &config) {
    in.into(config.DataID);
    in.into(config.Offset, places);
    in.into(config.MinDataLength, places);
    in.into(config.MaxDataLength);
    in.into(config.MaxDeltaCounter);
}

std::unique_ptr<uint8[]> exactly(const Input &in, std::size_t size) {
    std::unique_ptr<uint8[]> packet(new uint8[size]());
    std::memcpy(packet.get(), in.at, std::min(size, in.left));
    return packet;
}

// Profiles with a Length argument and the rules of e2e.md section 6.
#define LATER_PROFILE(P, top, fixed_length)                                                        \
    void fuzz_##P(Input in) {                                                                      \
        E2E_##P##ConfigType config{};                                                              \
        E2E_##P##CheckStateType state{};                                                           \
        fill(in, config);                                                                          \
        in.into(state.Counter);                                                                    \
        const std::size_t size = in.left;                                                          \
        const auto length = static_cast<                                                           \
            std::conditional_t<std::is_same_v<decltype(state.Counter), uint32>, uint32, uint16>>(  \
            size);                                                                                 \
        fixed_length;                                                                              \
        E2E_##P##CheckConfig(&config);                                                             \
        const auto packet = exactly(in, size);                                                     \
        const auto before = state;                                                                 \
        const Std_ReturnType checked = E2E_##P##Check(&config, &state, packet.get(), length);      \
        require(checked == E2E_E_OK || checked == E2E_E_INPUTERR_WRONG);                           \
        require(checked == E2E_E_OK ||                                                             \
                (state.Counter == before.Counter && state.Status == before.Status));               \
        E2E_##P##ProtectStateType sender{};                                                        \
        sender.Counter = static_cast<decltype(sender.Counter)>(before.Counter % ((top) + 1ULL));   \
        const Std_ReturnType sent = E2E_##P##Protect(&config, &sender, packet.get(), length);      \
        require(sent == checked);                                                                  \
        if (sent == E2E_E_OK) {                                                                    \
            E2E_##P##Check(&config, &state, packet.get(), length);                                 \
            require(!fields_apart(config) || state.Status != E2E_##P##STATUS_ERROR);               \
            E2E_##P##Protect(&config, &sender, packet.get(), length);                              \
            E2E_##P##Check(&config, &state, packet.get(), length);                                 \
            require(!fields_apart(config) ||                                                       \
                    state.Status == (config.MaxDeltaCounter > 0 ? E2E_##P##STATUS_OK               \
                                                                : E2E_##P##STATUS_WRONGSEQUENCE)); \
        }                                                                                          \
    }

// With CRC, counter and ID nibble on top of each other nothing can be said of what was protected.
template <class C> bool fields_apart(const C &) {
    return true;
}
template <class C> bool packet_fields_apart(const C &config, bool nibble) {
    const auto crc = config.CRCOffset / 8;
    return config.CounterOffset / 8 != crc && config.CounterOffset % 8 % 4 == 0 &&
           (!nibble || (config.DataIDNibbleOffset / 8 != crc &&
                        config.DataIDNibbleOffset / 4 != config.CounterOffset / 4 &&
                        config.DataIDNibbleOffset % 4 == 0));
}
bool fields_apart(const E2E_P01ConfigType &config) {
    return packet_fields_apart(config, config.DataIDMode == E2E_P01_DATAID_NIBBLE);
}
bool fields_apart(const E2E_P11ConfigType &config) {
    return packet_fields_apart(config, config.DataIDMode == E2E_P11_DATAID_NIBBLE);
}

LATER_PROFILE(P04, 0xFFFFULL, )
LATER_PROFILE(P05, 0xFFULL, config.DataLength = static_cast<uint16>(8 * size))
LATER_PROFILE(P06, 0xFFULL, )
LATER_PROFILE(P07, 0xFFFFFFFFULL, )
LATER_PROFILE(P08, 0xFFFFFFFFULL, )
LATER_PROFILE(P11, 14ULL, config.DataLength = static_cast<uint16>(8 * size))
LATER_PROFILE(P22, 15ULL, config.DataLength = static_cast<uint16>(8 * size))
LATER_PROFILE(P44, 0xFFFFULL, )

std::size_t bytes_touched(const E2E_P01ConfigType &config) {
    return std::max({config.DataLength / 8, config.CRCOffset / 8 + 1, config.CounterOffset / 8 + 1,
                     config.DataIDNibbleOffset / 8 + 1});
}
std::size_t bytes_touched(const E2E_P02ConfigType &config) {
    return config.DataLength / 8;
}
bool fields_apart(const E2E_P02ConfigType &) {
    return true;
}

#define EARLY_PROFILE(P)                                                                           \
    void fuzz_##P(Input in) {                                                                      \
        E2E_##P##ConfigType config{};                                                              \
        E2E_##P##CheckStateType state{};                                                           \
        E2E_##P##ProtectStateType sender{};                                                        \
        fill(in, config);                                                                          \
        in.into(state.LastValidCounter);                                                           \
        in.into(state.MaxDeltaCounter);                                                            \
        in.into(state.WaitForFirstData, 2);                                                        \
        in.into(state.NewDataAvailable, 2);                                                        \
        in.into(state.SyncCounter);                                                                \
        in.into(state.NoNewOrRepeatedDataCounter);                                                 \
        E2E_##P##CheckConfig(&config);                                                             \
        const auto packet = exactly(in, bytes_touched(config));                                    \
        const auto before = state;                                                                 \
        const Std_ReturnType checked = E2E_##P##Check(&config, &state, packet.get());              \
        require(checked == E2E_E_OK || checked == E2E_E_INPUTERR_WRONG);                           \
        require(checked == E2E_E_OK || (state.Status == before.Status &&                           \
                                        state.LastValidCounter == before.LastValidCounter));       \
        if (E2E_##P##Protect(&config, &sender, packet.get()) == E2E_E_OK) {                        \
            state.NewDataAvailable = TRUE;                                                         \
            E2E_##P##Check(&config, &state, packet.get());                                         \
            require(!fields_apart(config) || state.Status != E2E_##P##STATUS_WRONGCRC);            \
        }                                                                                          \
    }

EARLY_PROFILE(P01)
EARLY_PROFILE(P02)

void fuzz_state_machine(Input in) {
    E2E_SMConfigType config{};
    in.into(config.WindowSizeValid);
    in.into(config.WindowSizeInit);
    in.into(config.WindowSizeInvalid);
    in.into(config.MinOkStateInit);
    in.into(config.MaxErrorStateInit);
    in.into(config.MinOkStateValid);
    in.into(config.MaxErrorStateValid);
    in.into(config.MinOkStateInvalid);
    in.into(config.MaxErrorStateInvalid);
    in.into(config.ClearToInvalid, 2);
    E2E_SMCheckConfig(&config);
    std::unique_ptr<uint8[]> window(new uint8[config.WindowSizeValid]);
    E2E_SMCheckStateType state{};
    state.ProfileStatusWindow = window.get();
    const Std_ReturnType begun = E2E_SMCheckInit(&state, &config);
    require((begun == E2E_E_OK) == (config.WindowSizeValid > 0));
    while (begun == E2E_E_OK && in.left > 0) {
        const std::uint32_t status = in.number(1) % 8;
        const auto before = state;
        const Std_ReturnType ret =
            E2E_SMCheck(static_cast<E2E_PCheckStatusType>(status), &config, &state);
        require(ret == (status <= 5 ? E2E_E_OK : E2E_E_INPUTERR_WRONG));
        require(ret == E2E_E_OK || state.SMState == before.SMState);
        require(state.WindowTopIndex < config.WindowSizeValid);
        require(state.OkCount + state.ErrorCount <= config.WindowSizeValid);
        require(state.SMState != E2E_SM_DEINIT && state.SMState <= E2E_SM_INVALID);
        require(before.SMState == E2E_SM_NODATA || state.SMState != E2E_SM_NODATA);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
    static void (*const targets[])(Input) = {fuzz_P01, fuzz_P02, fuzz_P04,          fuzz_P05,
                                             fuzz_P06, fuzz_P07, fuzz_P08,          fuzz_P11,
                                             fuzz_P22, fuzz_P44, fuzz_state_machine};
    if (size > 0) {
        targets[data[0] % std::size(targets)](Input{data + 1, std::min(size - 1, longest)});
    }
    return 0;
}
