#include "probes.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <numeric>
#include <tuple>

namespace coptersim {

namespace {

// The text before the copter's id, by kind.
constexpr const char *kBefore[] = {"PitchId", "RollId",  "YawId",   "PxId",    "PyId",
                                   "ClockId", "AnchXId", "AnchYId", "AnchZId", "RangeId"};
constexpr int kKinds = 10;
constexpr char kChannel[] = "ITS_DATA";
constexpr char kAnchor[] = "Anch";

bool has_anchor(ProbeKind kind) {
    return kind >= ProbeKind::anchor_x;
}

// Skips the text; false when something else stands there.
bool skip(const char **at, const char *text) {
    const std::size_t length = std::strlen(text);
    if (std::strncmp(*at, text, length) != 0)
        return false;
    *at += length;
    return true;
}

// An id as %d writes it.
bool read_id(const char **at, std::int32_t *id) {
    if (**at < '0' || **at > '9' || (**at == '0' && (*at)[1] >= '0' && (*at)[1] <= '9'))
        return false;
    const auto read = std::from_chars(*at, *at + std::strlen(*at), *id);
    *at = read.ptr;
    return read.ec == std::errc();
}

// The probe of that name of a copter and anchor that are there.
bool read_probe(const char *name, const Columns &copters, const Ranging &ranging,
                ActiveProbe *probe) {
    for (int k = 0; k < kKinds; ++k) {
        const char *at = name;
        std::int32_t id, anchor = 0;
        if (!skip(&at, kBefore[k]) || !read_id(&at, &id))
            continue;
        const auto kind = static_cast<ProbeKind>(k);
        if (has_anchor(kind) && (!skip(&at, kAnchor) || !read_id(&at, &anchor)))
            return false;
        const std::ptrdiff_t copter = copters.find(id);
        const int index = has_anchor(kind) ? ranging.find(anchor) : 0;
        if (*at != '\0' || copter < 0 || index < 0)
            return false;
        *probe = {static_cast<std::size_t>(copter), kind, static_cast<std::size_t>(index), name};
        return true;
    }
    return false;
}

bool read_channel(const char *name, const Columns &copters, std::size_t *copter) {
    std::int32_t id;
    if (!skip(&name, kChannel) || !read_id(&name, &id) || *name != '\0')
        return false;
    const std::ptrdiff_t found = copters.find(id);
    *copter = static_cast<std::size_t>(found);
    return found >= 0;
}

// A fault that takes packets to, or from, another channel: all of them have to be looked at.
bool crosses(const fc_listed &listed) {
    for (std::size_t i = 0; i < listed.fault_count; ++i)
        if (std::strcmp(listed.faults[i].model, "misroute") == 0 ||
            std::strcmp(listed.faults[i].model, "masquerade") == 0)
            return true;
    return false;
}

bool is_before(const ActiveProbe &a, const ActiveProbe &b) {
    return std::tie(a.copter, a.anchor, a.kind) < std::tie(b.copter, b.anchor, b.kind);
}

} // namespace

std::string probe_name(ProbeKind kind, std::int32_t copter, std::int32_t anchor) {
    std::string name = kBefore[static_cast<int>(kind)] + std::to_string(copter);
    return has_anchor(kind) ? name + kAnchor + std::to_string(anchor) : name;
}

std::string channel_name(std::int32_t receiver) {
    return kChannel + std::to_string(receiver);
}

bool Probes::refresh(fc_context *faults, const Columns &copters, const Ranging &ranging,
                     bool renewed) {
    const std::uint64_t changes = fc_change_count(faults);
    if (known_ && changes == changes_ && !renewed)
        return false;
    known_ = false;
    of_copters_.clear();
    of_ranges_.clear();
    channels_.clear();
    if (fc_is_watching(faults))
        add_everything(copters, ranging);
    else
        read_list(faults, copters, ranging);
    std::sort(of_copters_.begin(), of_copters_.end(), is_before);
    std::sort(of_ranges_.begin(), of_ranges_.end(), is_before);
    std::sort(channels_.begin(), channels_.end());
    changes_ = changes;
    known_ = true;
    return true;
}

void Probes::read_list(fc_context *faults, const Columns &copters, const Ranging &ranging) {
    struct Reading {
        Probes *probes;
        const Columns &copters;
        const Ranging &ranging;
        bool crossing, failed;
    } reading{this, copters, ranging, false, false};
    const auto visit = [](void *user, const fc_listed *listed) {
        auto &r = *static_cast<Reading *>(user);
        if (listed->fault_count == 0)
            return;
        try {
            ActiveProbe probe;
            std::size_t copter;
            if (listed->is_channel) {
                r.crossing = r.crossing || crosses(*listed);
                if (read_channel(listed->id, r.copters, &copter))
                    r.probes->channels_.push_back(copter);
            } else if (read_probe(listed->id, r.copters, r.ranging, &probe)) {
                auto &list = has_anchor(probe.kind) ? r.probes->of_ranges_ : r.probes->of_copters_;
                list.push_back(probe);
            }
        } catch (const std::bad_alloc &) {
            r.failed = true;
        }
    };
    if (fc_list(faults, visit, &reading) != FC_OK || reading.failed)
        throw std::bad_alloc();
    if (reading.crossing) {
        channels_.resize(copters.size());
        std::iota(channels_.begin(), channels_.end(), std::size_t{0});
    }
}

// While calls are counted or recorded also idle probes are called.
void Probes::add_everything(const Columns &copters, const Ranging &ranging) {
    for (std::size_t i = 0; i < copters.size(); ++i) {
        for (int k = 0; k < kKinds; ++k) {
            const auto kind = static_cast<ProbeKind>(k);
            if (!has_anchor(kind)) {
                of_copters_.push_back({i, kind, 0, probe_name(kind, copters.id[i], 0)});
                continue;
            }
            for (std::size_t a = 0; a < ranging.anchors().size(); ++a)
                of_ranges_.push_back(
                    {i, kind, a, probe_name(kind, copters.id[i], ranging.anchors()[a].id)});
        }
        channels_.push_back(i);
    }
}

} // namespace coptersim
