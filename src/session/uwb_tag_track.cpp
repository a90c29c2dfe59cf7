// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/uwb_tag_track.h"

#include <algorithm>
#include <cmath>

namespace agv::session {
namespace {

constexpr std::size_t rangesToStart = 3;
/// A position is not carried ahead by more than this, s: the vehicle may have stopped meanwhile.
constexpr double farthestAhead_s = 1.0;

std::string wholeSeconds(double seconds) { return std::to_string(std::lround(seconds)) + " s"; }

} // namespace

UwbTagTrack::UwbTagTrack(const UwbTag& tag, const std::vector<UwbAnchor>& anchors)
    : m_tag(tag),
      m_anchors(anchors),
      m_filter({.height_m = tag.z_m, .obstruction = {}})
{}

void UwbTagTrack::take(const protocol::RangeSet& ranges, double arrival_s)
{
    m_arrival_s = arrival_s;
    m_shown.clear();
    if (ranges.empty()) {
        m_ranges.clear();
        return;
    }
    gather(ranges);
    for (const estimation::AnchorRange& range : m_ranges)
        m_shown.push_back({.anchor = m_anchors[static_cast<std::size_t>(range.index)].id,
                           .range_m = range.range_m,
                           .residual_m = {},
                           .rejected = false});
    if (!m_ranges.empty())
        follow(ranges[0].time_s);
}

/// Firmware 1.06 spreads the ranges of an exchange over several lines: until there is a start they are
/// gathered.
void UwbTagTrack::gather(const protocol::RangeSet& ranges)
{
    const bool isSameExchange = ranges[0].sequence >= 0 && ranges[0].sequence == m_sequence;
    if (m_filter.started() || !isSameExchange)
        m_ranges.clear();
    m_sequence = ranges[0].sequence;
    m_unknownAnchor = -1;
    for (const RangeMeasurement& range : ranges) {
        const auto anchor = std::ranges::find(m_anchors, range.anchor, &UwbAnchor::id);
        const auto index = anchor - m_anchors.begin();
        if (anchor == m_anchors.end() || index >= estimation::kMaxAnchors)
            m_unknownAnchor = range.anchor;
        else
            m_ranges.add({.anchor = Eigen::Vector3d(anchor->x, anchor->y, anchor->z),
                          .range_m = range.range_m,
                          .index = static_cast<int>(index)});
    }
}

void UwbTagTrack::follow(double time_s)
{
    const double elapsed_s = time_s - m_measured_s;
    m_measured_s = time_s;
    if (m_filter.started() && elapsed_s > startAnewAfter_s)
        m_filter.stop();
    const estimation::AnchorRanges ranges{m_ranges.data(), m_ranges.size()};
    const bool hadPosition = m_filter.started();
    if (hadPosition) {
        m_filter.predict(elapsed_s);
    } else if (m_ranges.size() < rangesToStart || !m_filter.start(ranges)) {
        return;
    }
    const estimation::MeasurementRecords& records = m_filter.update(ranges);
    for (std::size_t i = 0; i < records.size(); ++i) { // in the order of the ranges
        m_shown[i].rejected = records[i].rejected;
        if (hadPosition) // else it is the position that these ranges gave
            m_shown[i].residual_m = records[i].innovation;
    }
    const auto rejected = std::ranges::count(m_shown, true, &UwbRangeSnapshot::rejected);
    const bool isContradicted = 2 * rejected > std::ssize(m_shown);
    m_contradictions = isContradicted ? m_contradictions + 1 : 0;
    if (m_contradictions <= contradictionsAllowed)
        return;
    m_contradictions = 0;
    m_filter.stop();
}

UwbTagSnapshot UwbTagTrack::snapshot(double now_s) const
{
    UwbTagSnapshot tag;
    tag.id = m_tag.id;
    tag.label = m_tag.label;
    tag.agv = m_tag.agv;
    tag.z_m = m_tag.z_m;
    tag.age_s = std::max(0.0, now_s - m_measured_s);
    tag.ranges = m_shown;
    if (!m_filter.started() || tag.age_s > shownFor_s) {
        tag.reason = whyNoPosition(now_s - m_arrival_s);
        return tag;
    }
    estimation::RangeEkf ahead = m_filter;
    ahead.predict(std::min(tag.age_s, farthestAhead_s));
    tag.position = Point2{ahead.state().x(), ahead.state().y()};
    const auto& covariance = ahead.covariance();
    tag.covariance = {covariance(0, 0), covariance(0, 1), covariance(1, 1)};
    return tag;
}

std::string UwbTagTrack::whyNoPosition(double age_s) const
{
    if (age_s > shownFor_s)
        return "Not heard for " + wholeSeconds(age_s) + ": the tag is off or out of reach";
    if (m_ranges.size() < rangesToStart && m_unknownAnchor >= 0)
        return "Anchor " + std::to_string(m_unknownAnchor) +
               " measures this tag, but is not in the plant file: enter where it is";
    if (m_ranges.size() < rangesToStart)
        return "Only " + std::to_string(m_ranges.size()) +
               " of the 3 ranges that a position needs: look for what hides the anchors";
    return "The ranges fit no position: check the anchors' places in the plant file";
}

} // namespace agv::session
