// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/trek_ranges.h"

#include <algorithm>
#include <utility>

namespace agv::protocol {

namespace {

constexpr int sequences = 256;
/// Between two reports of one tag: from 200 Hz to one in 3 s; anything else is a backlog or a silence.
constexpr double shortestPeriod_s = 0.005;
constexpr double longestPeriod_s = 3.0;
constexpr int mostExchangesInPeriod = 16;
constexpr std::size_t periodsToTrust = 3;
constexpr double periodWithoutClock_s = 0.1;

/// Both anchors of ranges 1 to 3 of an ma line.
struct AnchorPair {
    std::int32_t first;
    std::int32_t second;
};
constexpr std::array<AnchorPair, 4> anchorPairs{AnchorPair{-1, -1}, {0, 1}, {0, 2}, {1, 2}};

RangeSet anchorRanges(const TrekReport& report, double time_s)
{
    RangeSet ranges;
    if (report.rangeCount != anchorPairs.size())
        return ranges;
    for (std::size_t k = 1; k < anchorPairs.size(); ++k) {
        if (!report.isUsable(k))
            continue;
        ranges.add({.time_s = time_s,
                    .range_m = metresFromMm(report.range_mm[k]),
                    .tag = anchorPairs[k].first,
                    .anchor = anchorPairs[k].second,
                    .sequence = report.sequence,
                    .kind = RangeKind::AnchorAnchor});
    }
    return ranges;
}

} // namespace

RangeSet TrekRanges::read(const TrekReport& report)
{
    if (report.kind == TrekLineKind::Raw)
        return {};
    double time_s = timeOf_s(report);
    if (report.kind == TrekLineKind::Anchors)
        return anchorRanges(report, time_s);

    Tag& tag = m_tags[static_cast<std::size_t>(report.tag)];
    follow(tag, report, time_s);
    const double period_s = m_period_s.value_or(tag.traffic.reportPeriod_s);
    time_s -= period_s;
    // A period that becomes known must not turn the time of a tag back.
    if (m_base == TimeBase::Arrival && tag.traffic.reports > 1)
        time_s = std::max(time_s, tag.lastTime_s);
    tag.lastTime_s = time_s;
    return tagRanges(report, time_s, period_s);
}

double TrekRanges::timeOf_s(const TrekReport& report)
{
    if (m_base == TimeBase::Arrival)
        return secondsFrom(report.firstByte.time_since_epoch());
    if (report.deviceTime_ms >= 0)
        m_lastDeviceTime_s = static_cast<double>(report.deviceTime_ms) / 1e3;
    else
        m_lastDeviceTime_s += m_period_s.value_or(periodWithoutClock_s);
    return m_lastDeviceTime_s;
}

/// Counts the report and learns the period of its tag.
void TrekRanges::follow(Tag& tag, const TrekReport& report, double time_s)
{
    TagTraffic& traffic = tag.traffic;
    ++traffic.reports;
    const double waited_s = time_s - traffic.lastArrival_s;
    const bool isFresh = std::exchange(tag.isFresh, false);
    const int previous = std::exchange(traffic.lastSequence, report.sequence);
    if (isFresh) {
        traffic.lastArrival_s = time_s;
        return;
    }
    const bool hasSequence = report.sequence >= 0 && previous >= 0;
    const int step = hasSequence ? (report.sequence - previous + sequences) % sequences : 1;
    if (step == 0) {
        // Firmware 1.06 spreads one exchange over a line per anchor.
        traffic.repeated += report.kind == TrekLineKind::Single ? 0 : 1;
        return;
    }
    traffic.lastArrival_s = time_s;
    if (step > sequences / 2) {
        ++traffic.restarts;
        return;
    }
    traffic.missed += static_cast<std::uint64_t>(step - 1);
    if (step <= mostExchangesInPeriod)
        addPeriod(tag, waited_s / step);
}

void TrekRanges::addPeriod(Tag& tag, double period_s)
{
    if (period_s < shortestPeriod_s || period_s > longestPeriod_s)
        return;
    tag.periods_s[tag.periodCount++ % mostPeriods] = static_cast<float>(period_s);
    if (tag.periodCount < periodsToTrust)
        return;
    auto sorted = tag.periods_s;
    const std::size_t known = std::min(tag.periodCount, mostPeriods);
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(known / 2);
    std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(known));
    tag.traffic.reportPeriod_s = *middle;
}

RangeSet TrekRanges::tagRanges(const TrekReport& report, double time_s, double period_s) const
{
    RangeSet ranges;
    for (std::size_t k = 0; k < report.rangeCount; ++k) {
        if (!report.isUsable(k))
            continue;
        ranges.add({.time_s = time_s,
                    .range_m = metresFromMm(report.range_mm[k]),
                    .reportPeriod_s = period_s,
                    .tag = report.tag,
                    .anchor = report.firstAnchor + static_cast<std::int32_t>(k),
                    .sequence = report.sequence,
                    .kind = RangeKind::TagAnchor});
    }
    return ranges;
}

std::vector<int> TrekRanges::tags() const
{
    std::vector<int> heard;
    for (std::size_t i = 0; i < m_tags.size(); ++i)
        if (m_tags[i].traffic.reports > 0)
            heard.push_back(static_cast<int>(i));
    return heard;
}

void TrekRanges::reset()
{
    for (Tag& tag : m_tags) {
        tag.isFresh = true;
        tag.periodCount = 0;
        tag.traffic.reportPeriod_s = 0.0;
        tag.traffic.lastSequence = -1;
    }
}

} // namespace agv::protocol
