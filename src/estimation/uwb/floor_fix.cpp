// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/floor_fix.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

/// Ordered by source, each source once, the last reading wins.
std::vector<Heard> sortedOf(std::span<const Heard> readings)
{
    std::vector<Heard> sorted(readings.begin(), readings.end());
    std::ranges::stable_sort(sorted, {}, &Heard::source);
    std::vector<Heard> result;
    for (const Heard& heard : sorted) {
        if (!std::isfinite(heard.value))
            continue;
        if (!result.empty() && result.back().source == heard.source)
            result.back() = heard;
        else
            result.push_back(heard);
    }
    return result;
}

} // namespace

std::optional<Point2> meanOfTags(std::span<const Point2> tags)
{
    if (tags.empty())
        return {};
    Point2 sum;
    for (const Point2 tag : tags)
        sum = sum + tag;
    return (1.0 / static_cast<double>(tags.size())) * sum;
}

void FingerprintTable::add(Point2 place, std::span<const Heard> readings)
{
    m_entries.push_back({place, sortedOf(readings)});
}

double FingerprintTable::distanceTo(const Entry& entry, std::span<const Heard> sorted) const
{
    double sum = 0.0;
    std::size_t sources = 0;
    auto a = entry.readings.begin();
    auto b = sorted.begin();
    while (a != entry.readings.end() || b != sorted.end()) {
        double difference = 0.0;
        if (b == sorted.end() || (a != entry.readings.end() && a->source < b->source))
            difference = (a++)->value - m_missing;
        else if (a == entry.readings.end() || b->source < a->source)
            difference = (b++)->value - m_missing;
        else
            difference = (a++)->value - (b++)->value;
        sum += difference * difference;
        ++sources;
    }
    return sources > 0 ? std::sqrt(sum / static_cast<double>(sources)) : 0.0;
}

std::optional<FingerprintTable::Match> FingerprintTable::nearest(std::span<const Heard> readings) const
{
    return nearest(readings, 1);
}

std::optional<FingerprintTable::Match> FingerprintTable::nearest(std::span<const Heard> readings,
                                                                 std::size_t k) const
{
    const std::vector<Heard> sorted = sortedOf(readings);
    if (sorted.empty() || m_entries.empty() || k == 0)
        return {};
    std::vector<Match> matches;
    matches.reserve(m_entries.size());
    for (const Entry& entry : m_entries)
        matches.push_back({entry.place, distanceTo(entry, sorted)});
    k = std::min(k, matches.size());
    std::ranges::partial_sort(matches, matches.begin() + static_cast<std::ptrdiff_t>(k), {},
                              &Match::distance);
    if (k == 1 || matches.front().distance <= 0.0)
        return matches.front();
    Point2 sum;
    double weights = 0.0;
    for (std::size_t i = 0; i < k; ++i) {
        const double weight = 1.0 / matches[i].distance;
        sum = sum + weight * matches[i].place;
        weights += weight;
    }
    return Match{(1.0 / weights) * sum, matches.front().distance};
}

} // namespace agv::estimation
