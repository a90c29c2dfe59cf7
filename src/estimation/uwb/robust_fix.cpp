// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/robust_fix.h"

#include "estimation/uwb/consensus_fix.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/LU>

namespace agv::estimation {

namespace {

const double kLogTwoPi = std::log(2.0 * std::numbers::pi);
/// 1 + 16 + 16 * 15 / 2: nobody, one or two of kMaxAnchors hidden.
constexpr std::size_t kMostHypotheses = 137;
/// Chi-squared per range beyond which no set of hidden anchors explains the ranges.
constexpr double kUnexplained = 9.0;
/// Density of a range that means nothing, 1/m: a failed exchange may also be far too short.
constexpr double kMeaninglessDensity = 1e-3;
/// Evidence this far (natural logarithm) below the best adds nothing.
constexpr double kNegligible = 25.0;

struct Hypothesis {
    int first = -1;  ///< hidden range, or -1
    int second = -1; ///< hidden range, or -1
    double logEvidence = 0.0;
    UwbFix fix;

    bool hides(int i) const { return i == first || i == second; }
};

using Hypotheses = FixedList<Hypothesis, kMostHypotheses>;

double logPrior(const ObstructionModel& model, std::size_t ranges, int hidden)
{
    const double seen = std::clamp(model.seenAtFirst, 1e-6, 1.0 - 1e-6);
    return static_cast<double>(ranges - static_cast<std::size_t>(hidden)) * std::log(seen) +
           hidden * std::log(1.0 - seen);
}

double logDeterminant(const UwbFix& fix, bool planar)
{
    const double determinant =
        planar ? fix.covariance.topLeftCorner<2, 2>().determinant() : fix.covariance.determinant();
    return std::log(std::max(determinant, 1e-300));
}

class HiddenSets {
public:
    HiddenSets(AnchorRanges ranges, const RobustFixSettings& settings)
        : m_ranges(ranges),
          m_settings(settings)
    {
        m_fixSettings.height = settings.height;
        m_fixSettings.side = settings.side;
        m_planar = settings.height && settings.height->sd_m <= 0.0;
        const int n = static_cast<int>(ranges.size());
        add(-1, -1);
        for (int i = 0; n >= 4 && i < n; ++i)
            add(i, -1);
        for (int i = 0; n >= 5 && i < n; ++i)
            for (int k = i + 1; k < n; ++k)
                add(i, k);
    }

    Hypotheses& all() { return m_hypotheses; }
    const RangeFixSettings& fixSettings() const { return m_fixSettings; }
    FixStatus firstFailure() const { return m_failure; }

private:
    void add(int first, int second)
    {
        Hypothesis h{first, second, 0.0, {}};
        AnchorRangeList seen;
        const int hidden = (first >= 0 ? 1 : 0) + (second >= 0 ? 1 : 0);
        h.logEvidence = logPrior(m_settings.obstruction, m_ranges.size(), hidden);
        for (int i = 0; i < static_cast<int>(m_ranges.size()); ++i) {
            const AnchorRange& range = m_ranges[static_cast<std::size_t>(i)];
            if (h.hides(i))
                continue;
            seen.add(range);
            h.logEvidence -= 0.5 * kLogTwoPi + std::log(range.sd_m);
        }
        h.fix = fixFromRanges({seen.data(), seen.size()}, m_fixSettings);
        if (!h.fix.ok()) {
            if (first < 0)
                m_failure = h.fix.status;
            return;
        }
        h.logEvidence += -0.5 * h.fix.chiSquared + 0.5 * logDeterminant(h.fix, m_planar) +
                         (m_planar ? 1.0 : 1.5) * kLogTwoPi;
        for (const int i : {first, second})
            if (i >= 0)
                h.logEvidence += logHidden(h.fix, m_ranges[static_cast<std::size_t>(i)]);
        m_hypotheses.add(h);
    }

    double logHidden(const UwbFix& fix, const AnchorRange& range) const
    {
        const Eigen::Vector3d away = fix.position - range.anchor;
        const double d = std::max(away.norm(), 1e-6);
        const Eigen::Vector3d u = away / d;
        const double variance = u.dot(fix.covariance * u) + range.sd_m * range.sd_m;
        const double hidden = logNormalPlusExponential(range.range_m - d, std::sqrt(variance),
                                                       m_settings.obstruction.meanBias_m);
        return std::log(std::exp(hidden) + kMeaninglessDensity);
    }

    AnchorRanges m_ranges;
    RobustFixSettings m_settings;
    RangeFixSettings m_fixSettings;
    bool m_planar = false;
    Hypotheses m_hypotheses;
    FixStatus m_failure = FixStatus::Ok;
};

void record(RobustFix& result, AnchorRanges ranges)
{
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const Eigen::Vector3d away = result.fix.position - ranges[i].anchor;
        const double d = std::max(away.norm(), 1e-6);
        MeasurementRecord r;
        r.source = ranges[i].index;
        r.innovation = ranges[i].range_m - d;
        r.variance = ranges[i].sd_m * ranges[i].sd_m;
        r.testRatio = r.innovation * r.innovation / (kRecordGate * kRecordGate * r.variance);
        r.weight = result.probabilitySeen[i];
        r.rejected = r.weight < 0.5;
        r.fused = true;
        result.records.add(r);
    }
}

} // namespace

RobustFix robustFix(AnchorRanges ranges, const RobustFixSettings& settings)
{
    RobustFix result;
    UwbFix& fix = result.fix;
    fix.status = checkRanges(ranges, 3);
    if (!fix.ok())
        return result;
    HiddenSets sets(ranges, settings);
    Hypotheses& hypotheses = sets.all();
    if (hypotheses.empty()) {
        fix.status = sets.firstFailure();
        return result;
    }
    const Hypothesis* best = hypotheses.begin();
    for (const Hypothesis& h : hypotheses)
        if (h.logEvidence > best->logEvidence)
            best = &h;
    fix = best->fix;
    double total = 0.0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
    for (const Hypothesis& h : hypotheses) {
        if (h.logEvidence < best->logEvidence - kNegligible)
            continue;
        const double weight = std::exp(h.logEvidence - best->logEvidence);
        const Eigen::Vector3d away = h.fix.position - best->fix.position;
        total += weight;
        mean += weight * away;
        second += weight * (h.fix.covariance + away * away.transpose());
        for (int i = 0; i < static_cast<int>(ranges.size()); ++i)
            if (!h.hides(i))
                result.probabilitySeen[static_cast<std::size_t>(i)] += weight;
    }
    for (double& p : result.probabilitySeen)
        p /= total;
    mean /= total;
    fix.position += mean;
    fix.covariance = second / total - mean * mean.transpose();
    fix.dop = dopOf(ranges, fix.covariance);
    fix.used = static_cast<int>(ranges.size());
    if (ranges.size() >= 5 && best->fix.chiSquared > kUnexplained * static_cast<double>(ranges.size())) {
        const ConsensusFix consensus =
            consensusFix(ranges, sets.fixSettings(), settings.obstruction, kMeaninglessDensity);
        if (consensus.fix.ok()) {
            fix = consensus.fix;
            result.probabilitySeen = consensus.probabilitySeen;
        }
    }
    record(result, ranges);
    return result;
}

} // namespace agv::estimation
