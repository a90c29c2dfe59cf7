// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedure/range_calibration.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace agv::procedure {
namespace {

/// A tag that reports a hundred times a second for the longest time would fill no more.
constexpr std::size_t mostRangesOfAnAnchor = 60'000;

/// @pre not empty; `share` of the values lie below, 0..1. Reorders them.
double quantile(std::vector<double>& values, double share)
{
    const auto rank = std::lround(share * static_cast<double>(values.size() - 1));
    std::ranges::nth_element(values, values.begin() + rank);
    return values[static_cast<std::size_t>(rank)];
}

double median(std::vector<double>& values)
{
    const double upper = quantile(values, 0.5);
    if (values.size() % 2 == 1)
        return upper;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

std::string wholeMm(double m) { return std::to_string(std::lround(mmFromMetres(m))) + " mm"; }

std::string wholeSeconds(double s) { return std::to_string(std::lround(s)); }

} // namespace

Result<void> RangeCalibration::check(const CalibrationPlace& place, const std::vector<UwbAnchor>& anchors,
                                     double duration_s)
{
    if (anchors.empty())
        return failure(ErrorCode::BadInput, "There is no anchor in the list: enter where the anchors are");
    if (!std::isfinite(place.x) || !std::isfinite(place.y) || !std::isfinite(place.z))
        return failure(ErrorCode::BadInput, "The place of the tag is not known: enter where it stands");
    if (!(duration_s >= shortest_s && duration_s <= longest_s)) // a NaN too
        return failure(ErrorCode::BadInput, "The time of a calibration must lie between " +
                                                wholeSeconds(shortest_s) + " and " + wholeSeconds(longest_s) +
                                                " s: choose another");
    return {};
}

void RangeCalibration::start(int tag, const CalibrationPlace& place, const std::vector<UwbAnchor>& anchors,
                             double duration_s, Time now)
{
    m_tag = tag;
    m_start = now;
    m_anchors.clear();
    m_reason.clear();
    if (const Result<void> checked = check(place, anchors, duration_s); !checked) {
        m_state = RangeCalibrationState::Failed;
        m_reason = checked.error().detail;
        return;
    }
    m_state = RangeCalibrationState::Collecting;
    m_duration = durationFromSeconds(duration_s);
    for (const UwbAnchor& anchor : anchors)
        m_anchors.push_back(
            {.id = anchor.id,
             .distance_m = std::hypot(place.x - anchor.x, place.y - anchor.y, place.z - anchor.z),
             .ranges_m = {}});
}

void RangeCalibration::add(const RangeMeasurement& range, Time now)
{
    onTimer(now);
    if (m_state != RangeCalibrationState::Collecting || range.kind != RangeKind::TagAnchor ||
        range.tag != m_tag || !std::isfinite(range.range_m))
        return;
    const auto anchor = std::ranges::find(m_anchors, range.anchor, &Anchor::id);
    if (anchor != m_anchors.end() && anchor->ranges_m.size() < mostRangesOfAnAnchor)
        anchor->ranges_m.push_back(range.range_m);
}

void RangeCalibration::onTimer(Time now)
{
    if (m_state == RangeCalibrationState::Collecting && now - m_start >= m_duration)
        finish();
}

void RangeCalibration::finish()
{
    const bool isHeard =
        std::ranges::any_of(m_anchors, [](const Anchor& anchor) { return !anchor.ranges_m.empty(); });
    const bool isEnough = std::ranges::any_of(
        m_anchors, [](const Anchor& anchor) { return anchor.ranges_m.size() >= leastRanges; });
    m_state = isEnough ? RangeCalibrationState::Finished : RangeCalibrationState::Failed;
    if (isEnough)
        m_reason = whatToKnow();
    else if (isHeard)
        m_reason = "No anchor measured tag " + std::to_string(m_tag) + " " + std::to_string(leastRanges) +
                   " times: bring it nearer to the anchors or take longer";
    else
        m_reason = "Tag " + std::to_string(m_tag) +
                   " was not heard: switch it on and look whether the anchors are in reach";
}

/// The worst thing about the result.
std::string RangeCalibration::whatToKnow() const
{
    const Anchor* scattered = nullptr;
    double spread_m = largeSpread_m;
    std::string tooFew;
    for (const Anchor& anchor : m_anchors) {
        const RangeCalibrationRow row = rowOf(anchor);
        if (!row.offset_m) {
            tooFew += (tooFew.empty() ? "" : ", ") + std::to_string(anchor.id);
            continue;
        }
        if (std::abs(*row.offset_m) > largeOffset_m)
            return "The ranges of anchor " + std::to_string(anchor.id) + " are wrong by " +
                   wholeMm(std::abs(*row.offset_m)) +
                   ": check the places of the tag and the anchor before you use the offset";
        if (row.spread_m > spread_m) {
            scattered = &anchor;
            spread_m = row.spread_m;
        }
    }
    if (scattered != nullptr)
        return "The ranges of anchor " + std::to_string(scattered->id) + " scatter by " + wholeMm(spread_m) +
               ": look for what hides it, keep the tag still and calibrate again";
    if (!tooFew.empty())
        return "Anchors without an offset, because they measured the tag fewer than " +
               std::to_string(leastRanges) + " times: " + tooFew;
    return {};
}

void RangeCalibration::abort(const std::string& reason)
{
    if (m_state != RangeCalibrationState::Collecting)
        return;
    m_state = RangeCalibrationState::Failed;
    m_reason = reason;
}

void RangeCalibration::cancel()
{
    m_state = RangeCalibrationState::Idle;
    m_anchors.clear();
    m_reason.clear();
}

RangeCalibrationRow RangeCalibration::rowOf(const Anchor& anchor)
{
    RangeCalibrationRow row;
    row.anchor = anchor.id;
    row.count = static_cast<int>(anchor.ranges_m.size());
    if (anchor.ranges_m.size() < leastRanges)
        return row;
    std::vector<double> ranges_m = anchor.ranges_m;
    row.offset_m = anchor.distance_m - median(ranges_m);
    // Half the width of the middle 68 %: the sd of normal noise, and large when a sixth is obstructed.
    row.spread_m = 0.5 * (quantile(ranges_m, 0.84) - quantile(ranges_m, 0.16));
    return row;
}

RangeCalibrationSnapshot RangeCalibration::snapshot(Time now) const
{
    RangeCalibrationSnapshot snapshot;
    snapshot.state = m_state;
    if (m_state == RangeCalibrationState::Idle)
        return snapshot;
    snapshot.tag = m_tag;
    snapshot.reason = m_reason;
    if (m_state == RangeCalibrationState::Finished)
        snapshot.progress = 1.0;
    else if (m_state == RangeCalibrationState::Collecting)
        snapshot.progress = std::clamp(secondsFrom(now - m_start) / secondsFrom(m_duration), 0.0, 1.0);
    for (const Anchor& anchor : m_anchors)
        snapshot.rows.push_back(rowOf(anchor));
    return snapshot;
}

} // namespace agv::procedure
