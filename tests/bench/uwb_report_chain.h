// SPDX-License-Identifier: GPL-3.0-or-later
// From the bytes of a UWB unit to a position, as the live link and `locate` put it together, for the
// benchmarks and the count of allocations.
#pragma once

#include "core/random.h"
#include "estimation/uwb/range_ekf.h"
#include "protocol/trek_ranges.h"
#include "protocol/trek_stream.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace agv::chain {

/// The room of the thesis.
inline const std::array<Eigen::Vector3d, 4> anchors{
    Eigen::Vector3d(0, 0, 2), {4, 0, 2}, {4, 2, 2}, {0, 2, 2.5}};
inline constexpr double height_m = 0.7;
inline constexpr double period_s = 0.1;

/// What a unit sends of tags 0 to tags-1 that drive at 0.4 m/s on ellipses in the room, ten reports a second
/// and tag, 5 cm noise: `rounds` times one line of each.
inline std::string reportBytes(int tags, int rounds, std::uint64_t seed = 1)
{
    SplitMix64 random(seed);
    std::string bytes;
    for (int round = 0; round < rounds; ++round) {
        for (int tag = 0; tag < tags; ++tag) {
            const double angle = 2.0 * std::numbers::pi * tag / tags + 0.4 * period_s * round;
            const Eigen::Vector3d place(2.0 + 1.2 * std::cos(angle), 1.0 + 0.7 * std::sin(angle), height_m);
            protocol::TrekReport report;
            report.mask = 0x0f;
            report.tag = static_cast<std::int16_t>(tag);
            report.unit = 0;
            report.sequence = static_cast<std::int16_t>(round % 256);
            report.rangeNumber = static_cast<std::uint16_t>(round * tags + tag);
            report.debug = static_cast<std::uint32_t>(1000.0 * period_s * round);
            for (std::size_t k = 0; k < anchors.size(); ++k)
                report.range_mm[k] = static_cast<std::int32_t>(
                    std::lround(mmFromMetres((place - anchors[k]).norm() + 0.05 * random.normal())));
            bytes += protocol::encodeTrekReport(report) + "\r\n";
        }
    }
    return bytes;
}

/// The ranges of a report with the places of their anchors.
inline void place(const protocol::RangeSet& ranges, estimation::AnchorRangeList& placed)
{
    placed.clear();
    for (const RangeMeasurement& range : ranges)
        if (range.anchor < static_cast<std::int32_t>(anchors.size()))
            placed.add({.anchor = anchors[static_cast<std::size_t>(range.anchor)],
                        .range_m = range.range_m,
                        .index = range.anchor});
}

/// One unit and a filter for each of its tags.
class Tracks {
public:
    explicit Tracks(std::size_t tags) : m_tags(tags) {}

    /// One read of the port; gives the number of positions.
    std::size_t feed(std::string_view bytes, Time now)
    {
        std::size_t positions = 0;
        m_stream.feed(bytes, now, [&](const protocol::TrekReport& report) {
            const protocol::RangeSet ranges = m_ranges.read(report);
            if (ranges.empty())
                return;
            place(ranges, m_placed);
            positions +=
                m_tags[static_cast<std::size_t>(report.tag)].take(m_placed, ranges[0].time_s) ? 1 : 0;
        });
        return positions;
    }
    Eigen::Vector2d position(std::size_t tag) const { return m_tags[tag].filter.state().head<2>(); }

private:
    struct Tag {
        estimation::RangeEkf filter{{.height_m = height_m, .obstruction = {}}};
        double time_s = 0.0;

        bool take(const estimation::AnchorRangeList& placed, double now_s)
        {
            const estimation::AnchorRanges ranges{placed.data(), placed.size()};
            const double elapsed_s = now_s - std::exchange(time_s, now_s);
            if (!filter.started())
                return filter.start(ranges);
            filter.predict(elapsed_s);
            filter.update(ranges);
            return true;
        }
    };

    protocol::TrekStream m_stream;
    protocol::TrekRanges m_ranges;
    estimation::AnchorRangeList m_placed;
    std::vector<Tag> m_tags;
};

} // namespace agv::chain
