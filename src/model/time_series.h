// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace agv::model {

struct SeriesPoint {
    double t = 0.0; ///< s
    double value = 0.0;
    friend bool operator==(const SeriesPoint&, const SeriesPoint&) = default;
};

/// Values over time, for plots: bounded, and drawn at any zoom from a few points a pixel. Beside the points
/// it keeps the places of the smallest and the largest of every 4, 16, 64 ... of them, so that a picture
/// of a million points costs what one of some thousand does and loses no peak.
class TimeSeries {
public:
    explicit TimeSeries(std::size_t capacity = 100'000) : m_capacity(capacity) {}

    /// `t` must not fall; a value that is not finite, or a time before the last one, is left out. At capacity
    /// the oldest eighth is dropped.
    void append(double t, double value);
    void clear();

    std::size_t size() const { return m_points.size(); }
    bool empty() const { return m_points.empty(); }
    const SeriesPoint& front() const { return m_points.front(); }
    const SeriesPoint& back() const { return m_points.back(); }
    const std::vector<SeriesPoint>& points() const { return m_points; }

    /// What is to be drawn of [from, to]: the points, or, when there are more than two for each of `buckets`,
    /// the extreme ones of blocks of them, in order of time. One more on each side, where there is one, for
    /// the line that leaves the picture.
    void envelope(double from, double to, std::size_t buckets, std::vector<SeriesPoint>& out) const;
    /// The points of [from, to], both included.
    void range(double from, double to, std::vector<SeriesPoint>& out) const;

private:
    static constexpr std::size_t fanOut = 4;
    static constexpr std::size_t levelCount = 9;
    struct Extremes {
        std::uint32_t lowest = 0, highest = 0; ///< indexes into m_points
    };
    void enter(std::size_t index);
    std::size_t lowerIndex(double t) const;
    std::size_t upperIndex(double t) const;

    std::size_t m_capacity;
    std::vector<SeriesPoint> m_points;
    std::array<std::vector<Extremes>, levelCount> m_levels;
};

} // namespace agv::model
