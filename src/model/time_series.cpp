// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/time_series.h"

#include <algorithm>
#include <cmath>

namespace agv::model {

void TimeSeries::clear()
{
    m_points.clear();
    for (auto& level : m_levels)
        level.clear();
}

void TimeSeries::append(double t, double value)
{
    if (!std::isfinite(t) || !std::isfinite(value) || (!m_points.empty() && t < m_points.back().t))
        return;
    if (m_points.size() >= m_capacity) {
        const std::size_t dropped = std::max<std::size_t>(1, m_capacity / 8);
        m_points.erase(m_points.begin(), m_points.begin() + static_cast<std::ptrdiff_t>(dropped));
        for (auto& level : m_levels)
            level.clear();
        for (std::size_t i = 0; i < m_points.size(); ++i)
            enter(i);
    }
    m_points.push_back({t, value});
    enter(m_points.size() - 1);
}

void TimeSeries::enter(std::size_t index)
{
    const auto place = static_cast<std::uint32_t>(index);
    std::size_t block = index;
    for (auto& level : m_levels) {
        block /= fanOut;
        if (block == level.size()) {
            level.push_back({place, place});
            continue;
        }
        Extremes& extremes = level[block];
        if (m_points[index].value < m_points[extremes.lowest].value)
            extremes.lowest = place;
        if (m_points[index].value > m_points[extremes.highest].value)
            extremes.highest = place;
    }
}

std::size_t TimeSeries::lowerIndex(double t) const
{
    return static_cast<std::size_t>(std::ranges::lower_bound(m_points, t, {}, &SeriesPoint::t) -
                                    m_points.begin());
}

std::size_t TimeSeries::upperIndex(double t) const
{
    return static_cast<std::size_t>(std::ranges::upper_bound(m_points, t, {}, &SeriesPoint::t) -
                                    m_points.begin());
}

void TimeSeries::range(double from, double to, std::vector<SeriesPoint>& out) const
{
    out.clear();
    const std::size_t first = lowerIndex(from);
    const std::size_t end = upperIndex(to);
    if (first < end)
        out.assign(m_points.begin() + static_cast<std::ptrdiff_t>(first),
                   m_points.begin() + static_cast<std::ptrdiff_t>(end));
}

void TimeSeries::envelope(double from, double to, std::size_t buckets, std::vector<SeriesPoint>& out) const
{
    out.clear();
    if (m_points.empty() || !(from <= to) || buckets == 0)
        return;
    std::size_t first = lowerIndex(from);
    std::size_t end = upperIndex(to);
    first -= first > 0 ? 1 : 0;
    end += end < m_points.size() ? 1 : 0;
    const std::size_t count = end - first;
    if (count <= 2 * buckets) {
        out.assign(m_points.begin() + static_cast<std::ptrdiff_t>(first),
                   m_points.begin() + static_cast<std::ptrdiff_t>(end));
        return;
    }
    std::size_t level = 0;
    std::size_t span = fanOut;
    while (level + 1 < levelCount && count / (span * fanOut) >= buckets) {
        span *= fanOut;
        ++level;
    }
    const std::vector<Extremes>& blocks = m_levels[level];
    out.push_back(m_points[first]);
    for (std::size_t block = first / span; block < blocks.size() && block * span < end; ++block) {
        const auto [early, late] = std::minmax(blocks[block].lowest, blocks[block].highest);
        for (const std::uint32_t place : {early, late}) {
            if (place > first && place + 1 < end && m_points[place] != out.back())
                out.push_back(m_points[place]);
        }
    }
    out.push_back(m_points[end - 1]);
}

} // namespace agv::model
