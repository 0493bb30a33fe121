// Replays the calls recorded from the original library: every result must be the same.
#include "faultcheck_packet_wrapper.h"
#include "faultcheck_wrapper.h"

#include <nlohmann/json.hpp>
#include <zlib.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>

namespace {

using nlohmann::json;
using Call = bool (*)(const json &call); // true: the result is the recorded one

const char *id_of(const json &call) {
    return call[1].get_ref<const std::string &>().c_str();
}

double double_of(const json &text) {
    return std::strtod(text.get_ref<const std::string &>().c_str(), nullptr);
}

template <void (*F)(const char *, int)> bool with_int(const json &call) {
    F(id_of(call), call[2].get<int>());
    return true;
}

template <void (*F)(const char *, unsigned long)> bool with_ulong(const json &call) {
    F(id_of(call), call[2].get<unsigned long>());
    return true;
}

template <void (*F)(const char *, double)> bool with_double(const json &call) {
    F(id_of(call), double_of(call[2]));
    return true;
}

template <void (*F)(const char *)> bool with_id(const json &call) {
    F(id_of(call));
    return true;
}

template <void (*F)()> bool plain(const json &) {
    F();
    return true;
}

bool corrupt(const json &call) {
    faultcheck_packet_addFaultCorruptionBitFlip(id_of(call), call[2].get<int>(),
                                                call[3].get<int>());
    return true;
}

bool inject_int(const json &call) {
    int value = call[2].get<int>();
    faultcheck_injectFaultInt(id_of(call), &value);
    return value == call[3].get<int>();
}

bool inject_double(const json &call) {
    double value = double_of(call[2]);
    const double expected = double_of(call[3]);
    faultcheck_injectFaultDouble(id_of(call), &value);
    return std::memcmp(&value, &expected, sizeof value) == 0;
}

bool num_active(const json &call) {
    return faultcheck_numActiveFaults(id_of(call)) == call[2].get<int>();
}

std::string bytes_of(const std::string &hex) {
    std::string bytes;
    for (std::size_t at = 0; at < hex.size(); at += 2)
        bytes += static_cast<char>(std::stoi(hex.substr(at, 2), nullptr, 16));
    return bytes;
}

bool add_packet(const json &call) {
    const std::string bytes = bytes_of(call[2].get<std::string>());
    faultcheck_packet_addPacket(id_of(call), bytes.data(), static_cast<int>(bytes.size()));
    return true;
}

// Also what must not be touched is looked at: the rest of the buffer, the length of a get that
// returns 0.
bool get_packet(const json &call) {
    const std::string canary(64, '\x5a');
    std::string buffer = canary;
    int len = -77;
    const int result = faultcheck_packet_getPacket(id_of(call), &buffer[0], &len);
    if (call[2].is_null())
        return result == 0 && len == -77 && buffer == canary;
    const std::string expected = bytes_of(call[2].get<std::string>());
    return result == 1 && len == static_cast<int>(expected.size()) &&
           buffer == expected + canary.substr(expected.size());
}

const std::map<std::string, Call> kCalls = {
    {"faultcheck_addFaultBitFlip", with_int<faultcheck_addFaultBitFlip>},
    {"faultcheck_addFaultAmplification", with_double<faultcheck_addFaultAmplification>},
    {"faultcheck_addFaultOffset", with_double<faultcheck_addFaultOffset>},
    {"faultcheck_addFaultSetTo", with_double<faultcheck_addFaultSetTo>},
    {"faultcheck_setTriggerOnceAfterIterations",
     with_ulong<faultcheck_setTriggerOnceAfterIterations>},
    {"faultcheck_setTriggerAfterIterations", with_ulong<faultcheck_setTriggerAfterIterations>},
    {"faultcheck_setDurationAfterTrigger", with_int<faultcheck_setDurationAfterTrigger>},
    {"faultcheck_removeAllFaultsIdentifier", with_id<faultcheck_removeAllFaultsIdentifier>},
    {"faultcheck_removeAllFaults", plain<faultcheck_removeAllFaults>},
    {"faultcheck_injectFaultInt", inject_int},
    {"faultcheck_injectFaultDouble", inject_double},
    {"faultcheck_numActiveFaults", num_active},
    {"faultcheck_packet_addPacket", add_packet},
    {"faultcheck_packet_getPacket", get_packet},
    {"faultcheck_packet_addFaultCorruptionBitFlip", corrupt},
    {"faultcheck_packet_addFaultDrop", with_int<faultcheck_packet_addFaultDrop>},
    {"faultcheck_packet_addFaultRepeat", with_int<faultcheck_packet_addFaultRepeat>},
    {"faultcheck_packet_setTriggerOnceAfterIterations",
     with_ulong<faultcheck_packet_setTriggerOnceAfterIterations>},
    {"faultcheck_packet_setTriggerAfterIterations",
     with_ulong<faultcheck_packet_setTriggerAfterIterations>},
    {"faultcheck_packet_setDurationAfterTrigger",
     with_int<faultcheck_packet_setDurationAfterTrigger>},
    {"faultcheck_packet_removeAllFaultsIdentifier",
     with_id<faultcheck_packet_removeAllFaultsIdentifier>},
    {"faultcheck_packet_removeAllFaults", plain<faultcheck_packet_removeAllFaults>},
};

std::string read_gzip(const char *file) {
    std::string text;
    char part[1 << 16];
    gzFile in = gzopen(file, "rb");
    int got = 0;
    while (in != nullptr && (got = gzread(in, part, sizeof part)) > 0)
        text.append(part, static_cast<std::size_t>(got));
    if (in == nullptr || got < 0) {
        std::fprintf(stderr, "%s: cannot be read as a gzip file\n", file);
        std::exit(2);
    }
    gzclose(in);
    return text;
}

} // namespace

int main(int argc, char **argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s TRACES.json.gz\n", argv[0]);
        return 2;
    }
    const json sequences = json::parse(read_gzip(argv[1]));
    int calls = 0;
    int mismatches = 0;
    for (std::size_t at = 0; at < sequences.size(); ++at) {
        faultcheck_removeAllFaults();
        faultcheck_packet_removeAllFaults();
        for (const json &call : sequences[at]) {
            ++calls;
            if (kCalls.at(call[0].get<std::string>())(call))
                continue;
            ++mismatches;
            std::fprintf(stderr, "sequence %zu: %s gives another result\n", at,
                         call.dump().c_str());
        }
    }
    std::printf("%zu sequences, %d calls, %d mismatches\n", sequences.size(), calls, mismatches);
    return calls > 0 && mismatches == 0 ? 0 : 1;
}
