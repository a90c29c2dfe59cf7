// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/anchor_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace agv::session {
namespace {

double medianRange(std::span<const double> ranges_m)
{
    std::array<double, AnchorPairs::rangesKept> sorted{};
    const auto end = std::ranges::copy(ranges_m, sorted.begin()).out;
    const auto middle = sorted.begin() + std::distance(sorted.begin(), end) / 2;
    std::nth_element(sorted.begin(), middle, end);
    // Of an even number the mean of the middle two.
    return ranges_m.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(sorted.begin(), middle));
}

/// Of a single range; 0 of fewer than two.
double rangeSd(std::span<const double> ranges_m)
{
    if (ranges_m.size() < 2)
        return 0.0;
    const auto count = static_cast<double>(ranges_m.size());
    const double mean = std::reduce(ranges_m.begin(), ranges_m.end()) / count;
    double squares = 0.0;
    for (const double range_m : ranges_m)
        squares += (range_m - mean) * (range_m - mean);
    return std::sqrt(squares / (count - 1.0));
}

} // namespace

void AnchorPairs::add(const protocol::RangeSet& ranges)
{
    for (const RangeMeasurement& range : ranges) {
        if (range.kind != RangeKind::AnchorAnchor)
            continue;
        Pair& pair = m_pairs[std::minmax(range.tag, range.anchor)];
        if (isForgotten(pair, range.time_s))
            pair.ranges_m.clear();
        pair.ranges_m.add(range.range_m);
        pair.heard_s = range.time_s;
    }
}

std::vector<AnchorPairSnapshot> AnchorPairs::snapshot(double now_s) const
{
    std::vector<AnchorPairSnapshot> known;
    known.reserve(m_pairs.size());
    for (const auto& [ids, pair] : m_pairs)
        if (const std::span<const double> ranges_m = pair.ranges_m.values(); !isForgotten(pair, now_s))
            known.push_back({.first = ids.first,
                             .second = ids.second,
                             .range_m = medianRange(ranges_m),
                             .sd_m = rangeSd(ranges_m),
                             .count = static_cast<int>(ranges_m.size())});
    return known;
}

} // namespace agv::session
