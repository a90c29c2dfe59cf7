// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/anchor_statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace agv::session {
namespace {

ResidualSummary summaryOf(std::span<const double> residuals_m)
{
    const auto count = static_cast<double>(residuals_m.size());
    const double mean = std::accumulate(residuals_m.begin(), residuals_m.end(), 0.0) / count;
    const double squares =
        std::accumulate(residuals_m.begin(), residuals_m.end(), 0.0, [mean](double sum, double residual) {
            return sum + (residual - mean) * (residual - mean);
        });
    return {.mean_m = mean,
            .sd_m = std::sqrt(squares / (count - 1.0)),
            .count = static_cast<int>(residuals_m.size())};
}

} // namespace

void AnchorStatistics::setAnchors(const std::vector<UwbAnchor>& anchors)
{
    std::vector<Anchor> before = std::exchange(m_anchors, {});
    for (const UwbAnchor& anchor : anchors) {
        const auto known = std::ranges::find(before, anchor.id, &Anchor::id);
        m_anchors.push_back(known != before.end() ? std::move(*known) : Anchor());
        m_anchors.back().id = anchor.id;
    }
}

void AnchorStatistics::forgetResiduals()
{
    for (Anchor& anchor : m_anchors)
        anchor.residuals_m.clear();
}

AnchorStatistics::Anchor* AnchorStatistics::find(int id)
{
    const auto found = std::ranges::find(m_anchors, id, &Anchor::id);
    return found != m_anchors.end() ? &*found : nullptr;
}

void AnchorStatistics::heard(int anchor, Time arrival, Time measured)
{
    if (Anchor* known = find(anchor)) {
        known->rate.add(arrival);
        known->measured = measured;
    }
}

void AnchorStatistics::add(std::span<const UwbRangeSnapshot> ranges)
{
    for (const UwbRangeSnapshot& range : ranges)
        if (Anchor* known = find(range.anchor); known && range.residual_m)
            known->residuals_m.add(*range.residual_m);
}

std::vector<UwbAnchorSnapshot> AnchorStatistics::snapshot(Time now)
{
    std::vector<UwbAnchorSnapshot> snapshots;
    snapshots.reserve(m_anchors.size());
    for (Anchor& anchor : m_anchors) {
        UwbAnchorSnapshot entry;
        entry.id = anchor.id;
        entry.rangesPerSecond = anchor.rate.perSecond(now);
        if (anchor.measured)
            entry.age_s = std::max(0.0, secondsFrom(now - *anchor.measured));
        if (anchor.residuals_m.size() >= leastResiduals)
            entry.residual = summaryOf(anchor.residuals_m.values());
        snapshots.push_back(std::move(entry));
    }
    return snapshots;
}

} // namespace agv::session
