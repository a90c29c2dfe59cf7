// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "core/uwb_unit.h"
#include "protocol/trek_line.h"
#include "simulation/uwb_kit_settings.h"

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace agv::simulation {

/// Where the antenna of a UWB tag really is, plant frame, m.
struct UwbTagPlace {
    int tag = 0; ///< 0..255
    double x = 0.0, y = 0.0, z = 0.0;
};

/// Bytes that leave the port together.
struct UwbOutput {
    Time at;
    std::string bytes;
    friend bool operator==(const UwbOutput&, const UwbOutput&) = default;
};

/// A TREK1000-type kit made of numbers: anchors, tags, and the unit on the port (anchor 0) that reports them,
/// in any dialect. No clock, no port: places and commands in, bytes and their times out. The same seed and
/// the same calls give the same bytes. Not thread-safe.
///
/// Every tag ranges once a period, in a slot of its own. What a report says is of the exchange before: one
/// period old, as in the real firmware. TREK firmware answers deca?, deca$ and decA$, the last two with a
/// second of silence; clones and firmware 1.06 ignore what they are sent.
class UwbKit {
public:
    UwbKit(UwbKitSettings settings, Time start);

    /// Runs the slots up to `now` with the tags at these places; call it every few ms while they move. A tag
    /// that is left out is switched off.
    void step(Time now, std::span<const UwbTagPlace> tags);
    /// What has left the port up to `now`.
    std::vector<UwbOutput> take(Time now);
    /// Bytes that the port was sent.
    void receive(std::string_view bytes, Time now);

    Duration period() const;
    /// How often the port was sent anything; a clone must never be.
    std::uint64_t receivedBytes() const { return m_receivedBytes; }

    // Faults. Ids that the kit does not have are ignored.

    void setAnchorMissing(int anchor, bool isMissing);
    /// All tags see this anchor `extra_m` too far away.
    void blockAnchor(int anchor, double extra_m, Duration duration, Time now);
    void setMissRate(double share);       ///< 0..1
    void printGarbage(std::size_t count); ///< at the next step, in the middle of everything else
    /// The unit on the port loses its USB for `away`; it starts anew when it is back.
    void unplug(Duration away, Time now);
    bool isPlugged(Time now) const { return !m_backAt || now >= *m_backAt; }
    /// Undoes every fault.
    void restore(Time now);

private:
    static constexpr std::size_t mostAnchors = protocol::mostTrekRanges;
    using Ranges = std::array<std::int32_t, mostAnchors>; ///< mm; 0: not measured

    struct Pair {
        double bias_m = 0.0;
        Time nextBurst;
        Time burstEnd;
        double extra_m = 0.0;
    };
    struct Anchor {
        UwbAnchor place;
        bool isPresent = false;
        bool isMissing = false;
        Time blockedUntil;
        double blockedExtra_m = 0.0;
    };
    struct Tag {
        SplitMix64 random{0};
        std::array<Pair, mostAnchors> pairs;
        Time nextSlot;
        std::optional<Ranges> measured; ///< of the exchange before
        std::uint8_t sequence = 0;      ///< of the next exchange
    };

    bool isTrek() const;
    std::size_t rangeCount() const;
    void switchOn(int id, Time now);
    void boot(Time at);
    void runSlot(Tag& tag, const UwbTagPlace& place);
    Ranges measure(Tag& tag, const UwbTagPlace& place, Time at);
    std::int32_t rangeTo(std::size_t anchor, Tag& tag, const UwbTagPlace& place, Time at);
    void updateBurst(Pair& pair, SplitMix64& random, Time at) const;
    Duration untilBurst(SplitMix64& random) const;

    void report(int id, const Ranges& ranges, std::uint8_t sequence, Time at);
    void reportSingles(int id, const Ranges& ranges, std::uint8_t sequence, Time at);
    void reportAnchors(Time at);
    protocol::TrekReport reportOf(int id, const Ranges& ranges, std::uint8_t sequence, Time at) const;
    std::uint32_t deviceTime_ms(Time at) const;
    void answer(std::string_view command, Time now);
    void print(std::string_view line, Time at);
    void send(std::string_view bytes, Time at);

    UwbKitSettings m_settings;
    UwbRangeModel m_healthy;
    SplitMix64 m_random;
    std::array<Anchor, mostAnchors> m_anchors;
    std::map<int, Tag> m_tags;
    Time m_start;
    Time m_booted;
    Time m_nextAnchorRanges;
    std::uint8_t m_anchorSequence = 0;
    std::uint16_t m_rangeNumber = 0;
    bool m_rawReports = true;
    Time m_silentUntil;
    std::optional<Time> m_backAt;
    std::string m_command; ///< the last bytes received
    std::uint64_t m_receivedBytes = 0;
    std::size_t m_garbage = 0;
    std::deque<UwbOutput> m_output;
    Time m_portBusyUntil;
};

} // namespace agv::simulation
