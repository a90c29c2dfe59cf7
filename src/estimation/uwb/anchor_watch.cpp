// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/anchor_watch.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

constexpr int kLeastRangesWatched = 4;
constexpr int kSamplesBetweenDecisions = 10;
constexpr double kStandingPeriod_s = 1.0;
constexpr double kDeviationsOfMoved = 4.0;
/// What must be left of the misfit at most.
constexpr double kMisfitLeft = 0.8;
/// By how much the log likelihood must be above that of the list as it is and of the next best explanation.
constexpr double kMuchBetter = 25.0;
constexpr double kClearlyBetter = 8.0;
constexpr double kClearlyBetterStanding = 3.0;
/// The noise of the ranges is taken for no smaller than half of AnchorFaultModel::rangeSd_m.
constexpr double kLeastNoise = 0.25;
/// Median of chi squared over its degrees of freedom, for two of them.
constexpr double kMedianOfMisfit = 0.69;
/// A range that is too short by more than this is no noise.
constexpr double kShortRange_m = 0.06;
constexpr std::size_t kLeastShortRanges = 8;
/// Of the shortness that the displacement explains so much must be measured (median).
constexpr double kShareOfExpected = 0.6;

std::string roundedMm(double m) { return std::to_string(10 * std::lround(mmFromMetres(m) / 10.0)) + " mm"; }

/// The best explanation by one fault of one anchor and the cost of the second best.
struct BestFault {
    int anchor = -1;
    AnchorFaultFit fit;
    double nextCost = 1e300;

    /// How much more likely it is than what costs `cost`, for the noise that its misfit shows.
    double betterBy(double cost) const
    {
        return (cost - fit.cost) / std::max(kLeastNoise, fit.misfit / kMedianOfMisfit);
    }
};

BestFault bestFault(const AnchorFaultModel& model, std::span<const RangeSample> samples, AnchorFault fault)
{
    BestFault best;
    best.fit.cost = 1e300;
    for (int anchor = 0; anchor < model.anchorCount(); ++anchor) {
        const AnchorFaultFit fit = model.fit(samples, fault, anchor);
        if (fit.cost < best.fit.cost) {
            best.nextCost = best.fit.cost;
            best.anchor = anchor;
            best.fit = fit;
        } else {
            best.nextCost = std::min(best.nextCost, fit.cost);
        }
    }
    return best;
}

} // namespace

std::string toText(const AnchorDoubt& doubt)
{
    if (doubt.fault == AnchorFault::Moved)
        return "Ranges fit a place " + roundedMm(doubt.size_m) +
               " from the one in the list: measure the anchor again or restore it";
    if (doubt.size_m > 0.0)
        return "Ranges are " + roundedMm(doubt.size_m) +
               " too long: the anchor may have been moved or be hidden; look at it";
    return "Ranges are " + roundedMm(-doubt.size_m) +
           " too short: the anchor may have been moved; measure it again or calibrate its ranges";
}

void AnchorWatch::add(AnchorRanges ranges, const Eigen::Vector2d& position, double time_s)
{
    RangeSample sample;
    sample.position = position;
    int count = 0;
    for (const AnchorRange& range : ranges) {
        if (range.index < 0 || range.index >= m_model.anchorCount() || !(range.range_m > 0.0))
            continue;
        sample.range_m[static_cast<std::size_t>(range.index)] = static_cast<float>(range.range_m);
        ++count;
    }
    if (count < kLeastRangesWatched || !position.allFinite())
        return;
    if ((position - m_place).norm() >= stepOfSamples_m)
        addDriven(sample, time_s);
    else
        addStanding(sample, time_s);
}

void AnchorWatch::addDriven(const RangeSample& sample, double time_s)
{
    m_place = sample.position;
    m_standing.clear();
    m_standsSince_s = m_lastStanding_s = time_s;
    m_driven.add(sample);
    if (++m_newSamples < kSamplesBetweenDecisions || std::ssize(m_driven.values()) < samplesToDecide)
        return;
    m_newSamples = 0;
    std::optional<AnchorDoubt> doubt = movedAnchor();
    if (!doubt)
        doubt = offsetAnchor(m_driven.values());
    const bool isSame =
        doubt && m_suspicion && doubt->fault == m_suspicion->fault && doubt->anchor == m_suspicion->anchor;
    m_decisionsInARow = isSame ? m_decisionsInARow + 1 : 1;
    m_suspicion = doubt;
    if (!doubt || m_decisionsInARow >= decisionsToSay)
        m_doubt = doubt;
}

void AnchorWatch::addStanding(const RangeSample& sample, double time_s)
{
    if (time_s - m_lastStanding_s < kStandingPeriod_s)
        return;
    m_lastStanding_s = time_s;
    m_standing.add(sample);
    const bool isKnownToBeMoved = m_doubt && m_doubt->fault == AnchorFault::Moved;
    if (isKnownToBeMoved || time_s - m_standsSince_s < persistence_s ||
        std::ssize(m_standing.values()) < samplesToDecide)
        return;
    const RangeSample median = medianWhileStanding();
    m_doubt = offsetAnchor({&median, 1});
}

std::optional<AnchorDoubt> AnchorWatch::movedAnchor() const
{
    const std::span<const RangeSample> samples = m_driven.values();
    const AnchorFaultFit asListed = m_model.fit(samples, AnchorFault::None, -1);
    const BestFault moved = bestFault(m_model, samples, AnchorFault::Moved);
    const double size_m = moved.fit.displacement.norm();
    if (size_m < leastDisplacement_m || moved.fit.samples < samplesToDecide ||
        moved.fit.misfit > kMisfitLeft * asListed.misfit || moved.betterBy(moved.nextCost) < kClearlyBetter ||
        moved.betterBy(asListed.cost) < kMuchBetter)
        return std::nullopt;
    const Eigen::Vector2d direction = moved.fit.displacement / size_m;
    const double sd_m = std::sqrt(std::max(0.0, direction.dot(moved.fit.covariance * direction)));
    const AnchorFaultFit hidden = m_model.fit(samples, AnchorFault::Offset, moved.anchor);
    if (size_m < kDeviationsOfMoved * sd_m || moved.betterBy(hidden.cost) < kClearlyBetter ||
        !hasShortRanges(moved.anchor, moved.fit.displacement))
        return std::nullopt;
    return AnchorDoubt{AnchorFault::Moved, moved.anchor, size_m};
}

/// Where the displacement makes ranges too short the measured ones must be so too: those of an anchor that is
/// hidden from one part of the plant are not.
bool AnchorWatch::hasShortRanges(int anchor, const Eigen::Vector2d& displacement) const
{
    std::array<double, AnchorFaultModel::mostSamples> shares{};
    std::size_t count = 0;
    for (const RangeSample& sample : m_driven.values()) {
        const double expected_m = -m_model.direction(sample, anchor).dot(displacement);
        const std::optional<double> residual_m = m_model.residualByOthers(sample, anchor);
        if (residual_m && expected_m < -kShortRange_m)
            shares[count++] = *residual_m / expected_m;
    }
    if (count < kLeastShortRanges)
        return false;
    const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(shares.begin(), middle, shares.begin() + static_cast<std::ptrdiff_t>(count));
    return *middle > kShareOfExpected;
}

std::optional<AnchorDoubt> AnchorWatch::offsetAnchor(std::span<const RangeSample> samples) const
{
    const bool isOne = samples.size() == 1; // then the misfit is that of a few ranges
    const double clearly = isOne ? kClearlyBetterStanding : kClearlyBetter;
    const double much = isOne ? kClearlyBetterStanding : kMuchBetter;
    const AnchorFaultFit asListed = m_model.fit(samples, AnchorFault::None, -1);
    const BestFault offset = bestFault(m_model, samples, AnchorFault::Offset);
    if (offset.fit.samples == 0 || std::abs(offset.fit.offset_m) < leastOffset_m ||
        offset.betterBy(offset.nextCost) < clearly || offset.betterBy(asListed.cost) < much ||
        offset.fit.misfit > kMisfitLeft * asListed.misfit)
        return std::nullopt;
    return AnchorDoubt{AnchorFault::Offset, offset.anchor, offset.fit.offset_m};
}

RangeSample AnchorWatch::medianWhileStanding() const
{
    RangeSample median;
    median.position = m_place;
    std::array<float, standingKept> values{};
    for (std::size_t i = 0; i < median.range_m.size(); ++i) {
        std::size_t count = 0;
        for (const RangeSample& sample : m_standing.values())
            if (sample.range_m[i] > 0.0F)
                values[count++] = sample.range_m[i];
        if (2 * count < m_standing.size())
            continue;
        const auto middle = values.begin() + static_cast<std::ptrdiff_t>(count / 2);
        std::nth_element(values.begin(), middle, values.begin() + static_cast<std::ptrdiff_t>(count));
        median.range_m[i] = *middle;
    }
    return median;
}

} // namespace agv::estimation
