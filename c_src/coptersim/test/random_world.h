// A simulation drawn from a seed: copters in a box with walls, commands, and faults that come and
// go.
//
// Everything is decided before it runs, so that the same world can be run in several ways. Runs are
// compared by digests of all states, stations, maps and collisions.
#pragma once

#include "csim.h"
#include "fc.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    std::uint64_t next() { // splitmix64
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15u;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }
    int below(int n) {
        return static_cast<int>(next() % static_cast<std::uint64_t>(n));
    }
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(next() >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_;
};

// FNV-1a over the bytes of everything that can be seen of a simulation.
class Digest {
  public:
    template <class T> void add(const T &value) {
        unsigned char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        for (unsigned char byte : bytes)
            hash_ = (hash_ ^ byte) * 0x100000001b3u;
    }
    std::uint64_t value() const {
        return hash_;
    }

  private:
    std::uint64_t hash_ = 0xcbf29ce484222325u;
};

struct WorldOptions {
    int copters = 10;
    bool faults = true;
    bool its_always_rare = false; // every 20 steps: quick with many copters
    int id_step = 1;              // ids are id_first + i * id_step
    int id_first = 0;
};

class RandomWorld {
  public:
    RandomWorld(std::uint64_t seed, const WorldOptions &options) : options_(options) {
        Random random(seed);
        side_ = 4 + 3 * std::ceil(std::sqrt(options.copters));
        draw_parameters(random);
        for (int at = 0; at < kPieces; ++at)
            draw_piece(random, at);
    }

    static constexpr int kPieces = 24;

    void build(csim *sim) const {
        for (const auto &set : parameters_)
            csim_set(sim, set.first.c_str(), set.second);
        const double s = side_ / 2;
        csim_add_line(sim, 1000, -s, -s, s, -s);
        csim_add_line(sim, 1001, s, -s, s, s);
        csim_add_line(sim, 1002, s, s, -s, s);
        csim_add_line(sim, 7, -s, s, -s, -s);
        for (std::size_t i = 0; i < lines_.size(); ++i)
            csim_add_line(sim, 2000 + static_cast<int>(i), lines_[i].x1, lines_[i].y1, lines_[i].x2,
                          lines_[i].y2);
        for (int a = 0; a < 4; ++a)
            csim_add_anchor(sim, 9 - a, a < 2 ? -s : s, a % 2 ? -s : s, 1 + a);
        for (int i = 0; i < options_.copters; ++i)
            csim_add_copter(sim, id(i), starts_[static_cast<std::size_t>(i)].x1,
                            starts_[static_cast<std::size_t>(i)].y1,
                            starts_[static_cast<std::size_t>(i)].x2);
    }
    // The calls before a piece, then its steps in parts of at most `part`.
    void run_piece(csim *sim, int at, unsigned part) const {
        const Piece &piece = pieces_[static_cast<std::size_t>(at)];
        for (const auto &call : piece.calls)
            call(sim);
        for (unsigned left = piece.steps; left > 0;) {
            const unsigned now = left < part ? left : part;
            csim_run(sim, now, piece.dt_us, piece.its_div, piece.anchor_div);
            left -= now;
        }
    }
    std::uint64_t run(csim *sim, unsigned part = 1000000) const {
        build(sim);
        for (int at = 0; at < kPieces; ++at)
            run_piece(sim, at, part);
        return digest(sim);
    }

    // Without ids when they are not to matter.
    static std::uint64_t digest(const csim *sim) {
        Digest digest;
        for (const csim_view view : {CSIM_TRUE, CSIM_PERCEIVED}) {
            csim_columns_view c;
            csim_columns(sim, view, &c);
            for (int i = 0; i < c.count; ++i)
                for (const double *column :
                     {c.px, c.py, c.pz, c.vx, c.vy, c.roll, c.pitch, c.yaw, c.e_r, c.e_p})
                    digest.add(column[i] + 0.0);
            for (int i = 0; i < c.count; ++i)
                add_station(sim, c.id[i], &digest);
        }
        csim_collision hits[64];
        std::size_t count = 64;
        csim_collisions(sim, hits, &count);
        digest.add(count);
        for (std::size_t i = 0; i < count && i < 64; ++i) {
            digest.add(hits[i].t_us);
            digest.add(hits[i].x);
            digest.add(hits[i].y);
        }
        digest.add(csim_time(sim));
        return digest.value();
    }

    int id(int i) const {
        return options_.id_first + i * options_.id_step;
    }

  private:
    using Call = std::function<void(csim *)>;
    struct Piece {
        std::vector<Call> calls;
        unsigned steps;
        std::uint64_t dt_us;
        int its_div, anchor_div;
    };
    struct Quad {
        double x1, y1, x2, y2;
    };

    static void add_station(const csim *sim, int copter, Digest *digest) {
        csim_station s;
        csim_override(sim, copter, &s);
        digest->add(s.active);
        digest->add(s.roll);
        digest->add(s.pitch);
        digest->add(s.steps);
        digest->add(s.rejected);
        digest->add(s.max_pos_error);
        csim_ldm_entry entries[32];
        std::size_t count = 32;
        csim_ldm(sim, copter, entries, &count);
        digest->add(count);
        for (std::size_t i = 0; i < count && i < 32; ++i) {
            digest->add(entries[i].cx);
            digest->add(entries[i].along);
            digest->add(entries[i].angle);
            digest->add(entries[i].overlap);
        }
    }

    void draw_parameters(Random &random) {
        parameters_.push_back({"halt_on_collision", 0});
        parameters_.push_back({"integrator", random.below(3)});
        parameters_.push_back({"gate", random.below(4)});
        if (random.below(2) == 0) {
            parameters_.push_back({"risk_age_gain", random.between(0, 2)});
            parameters_.push_back({"comfort_error_gain", random.between(0, 2)});
            parameters_.push_back({"brake_gain", random.between(0, 2)});
            parameters_.push_back({"plausibility", random.below(2)});
            parameters_.push_back({"protect", random.below(3)});
            parameters_.push_back({"silence_us", 2e5 * random.below(3)});
            parameters_.push_back({"state_guard", 0.5 * random.below(2)});
            parameters_.push_back({"acc_p", random.between(0, 0.3)});
            parameters_.push_back({"pos_i", random.between(0, 0.1)});
            parameters_.push_back({"drag_linear", random.between(0, 0.1)});
        }
        for (int i = 0; i < options_.copters; ++i)
            starts_.push_back({random.between(-side_ / 2, side_ / 2),
                               random.between(-side_ / 2, side_ / 2), random.between(-180, 180),
                               0});
        for (int i = random.below(30); i > 0; --i) {
            const double x = random.between(-side_, side_), y = random.between(-side_, side_);
            const bool point = random.below(4) == 0;
            lines_.push_back({x, y, point ? x : x + random.between(-2, 2),
                              point ? y : y + random.between(-2, 2)});
        }
    }

    void draw_piece(Random &random, int at) {
        Piece piece;
        for (int i = random.below(options_.copters + 1); i > 0; --i)
            piece.calls.push_back(draw_command(random));
        if (options_.faults && random.below(2) == 0)
            piece.calls.push_back(draw_fault(random));
        if (options_.faults && random.below(6) == 0)
            piece.calls.push_back([](csim *sim) {
                fc_remove_all_probe_faults(csim_faults(sim));
                fc_channel_remove_all_faults(csim_faults(sim));
            });
        if (random.below(5) == 0)
            piece.calls.push_back(draw_change(random));
        piece.steps = static_cast<unsigned>(1 + random.below(at % 4 == 0 ? 300 : 40));
        piece.dt_us = random.below(4) == 0 ? 10000 : 5000;
        piece.its_div = random.below(6) == 0 ? 300 : 1 + random.below(25);
        if (options_.its_always_rare)
            piece.its_div = 20;
        piece.anchor_div = random.below(25);
        pieces_.push_back(std::move(piece));
    }

    Call draw_command(Random &random) {
        const int copter = id(random.below(options_.copters));
        const double r = random.between(-1, 1), p = random.between(-1, 1),
                     y = random.between(-1, 1);
        return [=](csim *sim) { csim_command(sim, copter, r, p, y, 0); };
    }

    // Copters leave, come back, or are moved.
    Call draw_change(Random &random) {
        const int copter = id(random.below(options_.copters));
        const double x = random.between(-side_ / 2, side_ / 2),
                     y = random.between(-side_ / 2, side_ / 2);
        const int kind = random.below(4);
        return [=](csim *sim) {
            csim_state state;
            if (kind == 0)
                csim_remove_copter(sim, copter);
            else if (kind == 1)
                csim_add_copter(sim, copter, x, y, 0);
            else if (csim_get_state(sim, copter, CSIM_TRUE, &state) == CSIM_OK) {
                state.px = x;
                state.vy += 1;
                csim_set_state(sim, copter, kind == 2 ? CSIM_TRUE : CSIM_PERCEIVED, &state);
            }
        };
    }

    Call draw_fault(Random &random) {
        char name[64];
        const int copter = id(random.below(options_.copters));
        const int kind = random.below(8);
        const double size = random.between(-3, 3);
        const char *const probes[] = {"RollId%d", "PitchId%d", "YawId%d", "PxId%d", "PyId%d"};
        std::snprintf(name, sizeof name, kind < 5 ? probes[kind] : "RangeId%dAnch7", copter);
        const std::string probe = name;
        const int channel_kind = random.below(8), bit = random.below(8), byte = random.below(92);
        if (random.below(2) == 0)
            return [=](csim *sim) {
                fc_context *faults = csim_faults(sim);
                if (kind % 3 == 0)
                    fc_add_noise_gauss(faults, probe.c_str(), 0.3 * size);
                else if (kind == 4)
                    fc_add_bitflip(faults, probe.c_str(), 40 + bit * 3);
                else
                    fc_add_offset(faults, probe.c_str(), size / (kind == 3 ? 200 : 1));
                fc_trigger_duration(faults, fc_latest(faults, probe.c_str()), 1 + byte);
            };
        std::snprintf(name, sizeof name, "ITS_DATA%d", copter);
        const std::string channel = name;
        const int other = id(random.below(options_.copters));
        std::snprintf(name, sizeof name, "ITS_DATA%d", other);
        const std::string target = name;
        return [=](csim *sim) {
            arm_channel(csim_faults(sim), channel.c_str(), target.c_str(), channel_kind, byte, bit);
        };
    }

    static void arm_channel(fc_context *faults, const char *channel, const char *target, int kind,
                            int byte, int bit) {
        switch (kind) {
        case 0:
            fc_channel_add_corruption(faults, channel, byte, bit);
            break;
        case 1:
            fc_channel_add_drop(faults, channel, byte);
            break;
        case 2:
            fc_channel_add_delay(faults, channel, 1 + bit);
            break;
        case 3:
            fc_channel_add_delay_time(faults, channel, 1000000LL * byte * 5);
            break;
        case 4:
            fc_channel_add_repeat_last(faults, channel);
            break;
        case 5:
            fc_channel_add_misroute(faults, channel, target);
            break;
        case 6:
            fc_channel_add_truncate(faults, channel, static_cast<std::size_t>(byte));
            break;
        default:
            fc_channel_add_extend(faults, channel, static_cast<std::size_t>(3 * byte), 0xff);
        }
    }

    WorldOptions options_;
    double side_ = 0;
    std::vector<std::pair<std::string, double>> parameters_;
    std::vector<Quad> starts_, lines_;
    std::vector<Piece> pieces_;
};
