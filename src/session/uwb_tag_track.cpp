// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/uwb_tag_track.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace agv::session {
namespace {

constexpr std::size_t rangesToStart = 3;
/// A position is not carried ahead by more than this, s: the vehicle may have stopped meanwhile.
constexpr double farthestAhead_s = 1.0;

std::string wholeSeconds(double seconds) { return std::to_string(std::lround(seconds)) + " s"; }

} // namespace

UwbTagTrack::UwbTagTrack(const UwbTag& tag, const std::vector<UwbAnchor>& anchors,
                         const std::vector<RangeCorrection>& corrections)
    : m_tag(tag),
      m_anchors(anchorsFor(tag.id, anchors, corrections)),
      m_filter({.height_m = tag.z_m, .obstruction = {}})
{}

std::vector<UwbTagTrack::Anchor> UwbTagTrack::anchorsFor(int tag, const std::vector<UwbAnchor>& anchors,
                                                         const std::vector<RangeCorrection>& corrections)
{
    std::vector<Anchor> used;
    for (const UwbAnchor& anchor : anchors) {
        if (used.size() == estimation::kMaxAnchors)
            break;
        const auto correction = std::ranges::find_if(corrections, [&](const RangeCorrection& candidate) {
            return candidate.anchor == anchor.id && candidate.tag == tag;
        });
        const double offset_m = correction != corrections.end() ? correction->offset_m : 0.0;
        used.push_back({.id = anchor.id, .x = anchor.x, .y = anchor.y, .z = anchor.z, .offset_m = offset_m});
    }
    return used;
}

bool UwbTagTrack::setLayout(const UwbTag& tag, const std::vector<UwbAnchor>& anchors,
                            const std::vector<RangeCorrection>& corrections)
{
    std::vector<Anchor> used = anchorsFor(tag.id, anchors, corrections);
    const bool isChanged = tag.z_m != m_tag.z_m || used != m_anchors;
    m_tag = tag;
    if (!isChanged)
        return false;
    m_anchors = std::move(used);
    m_filter = estimation::RangeEkf({.height_m = tag.z_m, .obstruction = {}});
    stop();
    m_ranges.clear();
    m_shown.clear();
    m_unknownAnchor = -1;
    return true;
}

/// The next ranges start the position anew.
void UwbTagTrack::stop()
{
    m_filter.stop();
    m_spread.clear();
    m_contradictions = 0;
}

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
        const auto anchor = std::ranges::find(m_anchors, range.anchor, &Anchor::id);
        const auto index = anchor - m_anchors.begin();
        if (anchor == m_anchors.end())
            m_unknownAnchor = range.anchor;
        else
            m_ranges.add({.anchor = Eigen::Vector3d(anchor->x, anchor->y, anchor->z),
                          .range_m = range.range_m + anchor->offset_m,
                          .index = static_cast<int>(index)});
    }
}

void UwbTagTrack::follow(double time_s)
{
    const double elapsed_s = time_s - m_measured_s;
    m_measured_s = time_s;
    if (m_filter.started() && elapsed_s > startAnewAfter_s)
        stop();
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
    m_spread.add({m_filter.state().x(), m_filter.state().y()});
    const auto rejected = std::ranges::count(m_shown, true, &UwbRangeSnapshot::rejected);
    const bool isContradicted = 2 * rejected > std::ssize(m_shown);
    m_contradictions = isContradicted ? m_contradictions + 1 : 0;
    if (m_contradictions > contradictionsAllowed)
        stop();
}

std::optional<Point2> UwbTagTrack::position() const
{
    if (!m_filter.started())
        return std::nullopt;
    return Point2{m_filter.state().x(), m_filter.state().y()};
}

PositionCovariance UwbTagTrack::covariance() const
{
    const auto& covariance = m_filter.covariance();
    return {covariance(0, 0), covariance(0, 1), covariance(1, 1)};
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
    tag.r95_m = m_spread.r95_m();
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
