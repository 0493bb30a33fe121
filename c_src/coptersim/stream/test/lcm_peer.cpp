/* lcm_peer.cpp: liblcm and the code of lcm-gen, as a peer for the tests of codecs in other
 * languages.
 *
 *   lcm_peer fingerprints         JSON: {"types": {"ack": "16 hexadecimal digits", ...}}
 *   lcm_peer messages SEED COUNT  COUNT messages of each channel, made up, one JSON line each:
 *                                 {"channel", "type", "value", "bytes": hexadecimal}
 *   lcm_peer log FILE SEED COUNT  the same messages as an LCM log, times 0, 1000, 2000 ... us
 *   lcm_peer read                 standard input: lines TYPE HEX. Decodes each one and answers
 *                                 "error", or the message as JSON, blank, what it encodes to as HEX
 *   lcm_peer publish URL SEED COUNT SIZE
 *                                 sends COUNT made-up messages of each channel, and last a frame of
 *                                 SIZE objects */
#include "visitors.hpp"

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <lcm/lcm-cpp.hpp>
#include <map>

using namespace viz_test;

namespace {

std::string hex(const std::string &bytes) {
    static const char digits[] = "0123456789abcdef";
    std::string text;
    for (unsigned char byte : bytes) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

std::string unhex(const std::string &text) {
    std::string bytes;
    for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
        bytes += static_cast<char>(std::stoi(text.substr(i, 2), nullptr, 16));
    }
    return bytes;
}

template <class M> void add_fingerprint(json &types) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(M::getHash()));
    types[M::getTypeName()] = text;
}

int fingerprints() {
    json types;
    add_fingerprint<viz::ack>(types), add_fingerprint<viz::anchor>(types);
    add_fingerprint<viz::case_info>(types), add_fingerprint<viz::command>(types);
    add_fingerprint<viz::control>(types), add_fingerprint<viz::ellipse>(types);
    add_fingerprint<viz::event>(types), add_fingerprint<viz::fault>(types);
    add_fingerprint<viz::faults>(types), add_fingerprint<viz::frame>(types);
    add_fingerprint<viz::object>(types), add_fingerprint<viz::poly>(types);
    add_fingerprint<viz::range>(types), add_fingerprint<viz::ranges>(types);
    add_fingerprint<viz::risk>(types), add_fingerprint<viz::status>(types);
    add_fingerprint<viz::world>(types);
    std::cout << json{{"types", types}}.dump(1) << '\n';
    return 0;
}

/* Calls f(channel, message) for each made-up message. */
template <class F> void each_message(std::uint64_t seed, int count, F f) {
    maker random(seed);
    for (int i = 0; i < count; i++) {
        each_channel([&](const char *channel, auto example) {
            f(channel, random.make<decltype(example)>());
        });
    }
}

int messages(std::uint64_t seed, int count) {
    each_message(seed, count, [](const char *channel, const auto &message) {
        std::cout << json{{"channel", channel},
                          {"type", message.getTypeName()},
                          {"value", printer::of(message)},
                          {"bytes", hex(bytes_of(message))}}
                         .dump()
                  << '\n';
    });
    return 0;
}

int log(const std::string &file, std::uint64_t seed, int count) {
    lcm::LogFile log(file, "w");
    if (!log.good()) {
        std::fprintf(stderr, "lcm_peer: cannot write %s\n", file.c_str());
        return 2;
    }
    std::int64_t t_us = 0;
    each_message(seed, count, [&](const char *channel, const auto &message) {
        std::string bytes = bytes_of(message);
        lcm::LogEvent event{};
        event.timestamp = t_us;
        event.channel = channel;
        event.datalen = static_cast<std::int32_t>(bytes.size());
        event.data = bytes.data();
        log.writeEvent(&event);
        t_us += 1000;
    });
    return 0;
}

template <class M> std::string read_one(const std::string &bytes) {
    M message;
    if (message.decode(bytes.data(), 0, static_cast<int>(bytes.size())) < 0) {
        return "error";
    }
    return printer::of(message).dump() + ' ' + hex(bytes_of(message));
}

int read() {
    std::map<std::string, std::string (*)(const std::string &)> readers;
    each_channel([&](const char *, auto example) {
        using message = decltype(example);
        readers[message::getTypeName()] = read_one<message>;
    });
    std::string type, bytes;
    while (std::cin >> type >> bytes) {
        auto reader = readers.find(type);
        std::cout << (reader == readers.end() ? "error" : reader->second(unhex(bytes))) << '\n'
                  << std::flush;
    }
    return 0;
}

int publish(const std::string &url, std::uint64_t seed, int count, int size) {
    lcm::LCM lcm(url);
    if (!lcm.good()) {
        return 2;
    }
    each_message(seed, count,
                 [&](const char *channel, const auto &message) { lcm.publish(channel, &message); });
    viz::frame frame{};
    frame.n = size;
    frame.objects.resize(static_cast<std::size_t>(size));
    for (int i = 0; i < size; i++) {
        frame.objects[static_cast<std::size_t>(i)].id = i;
    }
    return lcm.publish("VIZ_FRAME", &frame) == 0 ? 0 : 2;
}

} // namespace

int main(int argc, char **argv) {
    std::string command = argc > 1 ? argv[1] : "";
    auto number = [argv](int i) { return std::atoi(argv[i]); };
    if (command == "fingerprints" && argc == 2) {
        return fingerprints();
    }
    if (command == "messages" && argc == 4) {
        return messages(static_cast<std::uint64_t>(number(2)), number(3));
    }
    if (command == "log" && argc == 5) {
        return log(argv[2], static_cast<std::uint64_t>(number(3)), number(4));
    }
    if (command == "read" && argc == 2) {
        return read();
    }
    if (command == "publish" && argc == 6) {
        return publish(argv[2], static_cast<std::uint64_t>(number(3)), number(4), number(5));
    }
    std::fprintf(stderr, "lcm_peer: the comment of lcm_peer.cpp says what it takes\n");
    return 2;
}
