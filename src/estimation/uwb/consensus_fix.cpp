// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/consensus_fix.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

constexpr int kReweightings = 5;
/// A range weighs at least this share, so that a fix always has its three ranges.
constexpr double kLeastWeight = 1e-3;

struct Likelihood {
    double seen = 0.0;
    double other = 0.0;
    double log() const { return std::log(seen + other); }
    double probabilitySeen() const { return seen / (seen + other); }
};

Likelihood likelihoodOf(const AnchorRange& range, const Eigen::Vector3d& position,
                        const ObstructionModel& model, double outlier)
{
    const double e = range.range_m - (position - range.anchor).norm();
    const double z = e / range.sd_m;
    return {model.seenAtFirst * std::exp(-0.5 * z * z - std::log(range.sd_m) - kLogRootTwoPi),
            (1.0 - model.seenAtFirst) * std::exp(logNormalPlusExponential(e, range.sd_m, model.meanBias_m)) +
                outlier};
}

} // namespace

ConsensusFix consensusFix(AnchorRanges ranges, const RangeFixSettings& settings,
                          const ObstructionModel& model, double outlier)
{
    ConsensusFix result;
    result.fix.status = checkRanges(ranges, 3);
    if (!result.fix.ok())
        return result;
    result.fix.status = FixStatus::Diverged;
    double best = -1e300;
    for (std::size_t i = 0; i < ranges.size(); ++i)
        for (std::size_t k = i + 1; k < ranges.size(); ++k)
            for (std::size_t m = k + 1; m < ranges.size(); ++m) {
                const std::array three{ranges[i], ranges[k], ranges[m]};
                const UwbFix fix = fixFromRanges(three, settings);
                if (!fix.ok())
                    continue;
                double log = 0.0;
                for (const AnchorRange& range : ranges)
                    log += likelihoodOf(range, fix.position, model, outlier).log();
                if (log > best) {
                    best = log;
                    result.fix = fix;
                }
            }
    RangeFixSettings improve = settings;
    for (int n = 0; n < kReweightings && result.fix.ok(); ++n) {
        AnchorRangeList weighted;
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            AnchorRange range = ranges[i];
            const double p = likelihoodOf(range, result.fix.position, model, outlier).probabilitySeen();
            result.probabilitySeen[i] = p;
            range.sd_m /= std::sqrt(std::max(p, kLeastWeight));
            weighted.add(range);
        }
        improve.start = result.fix.position;
        const UwbFix next = fixFromRanges({weighted.data(), weighted.size()}, improve);
        if (!next.ok())
            break;
        result.fix = next;
    }
    return result;
}

} // namespace agv::estimation
