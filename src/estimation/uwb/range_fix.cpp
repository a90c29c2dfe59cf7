// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/range_fix.h"

#include "estimation/uwb/anchor_plane.h"
#include "estimation/uwb/range_residuals.h"

#include <algorithm>
#include <cmath>

namespace agv::estimation {

namespace {

constexpr int kMostIterations = 40;
constexpr double kSettled_m = 1e-8;
constexpr double kLastStep_m = 3e-4;
/// A step shorter than this is taken with exact second derivatives; farther out they may point uphill.
constexpr double kNear_m = 0.3;
/// Solutions on both sides fit alike when their chi-squared differ by less (odds of 90 to 1).
constexpr double kSameFit = 9.0;
constexpr double kLargestDamping = 1e12;

struct Minimum {
    Vec3 at;
    double cost = 0.0;
    int iterations = 0;
    bool settled = false;
};

template<int Dim>
Minimum descend(const RangeResiduals& residuals, Vec3 start)
{
    Minimum best{start, 0.0, 0, false};
    Slope slope = residuals.slope<Dim>(start);
    best.cost = slope.cost;
    double damping = 0.0;
    bool near = true;
    for (best.iterations = 1; best.iterations <= kMostIterations; ++best.iterations) {
        Vec3 step;
        bool exact = near && residuals.smooth();
        if (exact)
            exact = solveSymmetric<Dim>(slope.curvature(), slope.gradient, 0.0, step);
        if (!exact && !solveSymmetric<Dim>(slope.information, slope.gradient, damping, step)) {
            damping = std::max(10.0 * damping, 1e-6);
            if (damping > kLargestDamping)
                return best;
            continue;
        }
        const double length2 = step.x * step.x + step.y * step.y + step.z * step.z;
        const Vec3 next{best.at.x + step.x, best.at.y + step.y, best.at.z + step.z};
        if (length2 < kSettled_m * kSettled_m) {
            best.settled = true;
            return best;
        }
        // Newton steps converge quadratically: what is left after one this short is below a micrometre.
        if (exact && length2 < kLastStep_m * kLastStep_m) {
            best.at = next;
            best.settled = true;
            return best;
        }
        const Slope there = residuals.slope<Dim>(next);
        if (there.cost <= best.cost * (1.0 + 1e-12)) {
            best.at = next;
            best.cost = there.cost;
            slope = there;
            damping = damping > 1e-9 ? 0.2 * damping : 0.0;
            near = length2 < kNear_m * kNear_m;
        } else {
            // Uphill by rounding alone: nothing left to gain.
            if (length2 < 1e-14) {
                best.settled = true;
                return best;
            }
            near = false;
            damping = std::max(10.0 * damping, 1e-3);
            if (damping > kLargestDamping)
                return best;
        }
    }
    return best;
}

Eigen::Vector3d toEigen(Vec3 v) { return {v.x, v.y, v.z}; }

/// Covariance, accuracy and residuals of a settled minimum.
template<int Dim>
void conclude(const RangeResiduals& residuals, const Minimum& minimum, UwbFix& fix)
{
    fix.position = toEigen(minimum.at);
    fix.iterations += minimum.iterations;
    fix.used = residuals.size();
    if (!minimum.settled) {
        fix.status = FixStatus::Diverged;
        return;
    }
    const Summary summary = residuals.summary<Dim>(minimum.at);
    fix.chiSquared = summary.chiSquared;
    fix.residual_m = summary.residual_m;
    Symmetric covariance;
    if (!invertSymmetric<Dim>(summary.information, covariance)) {
        fix.status = FixStatus::UnseenDirection;
        return;
    }
    fix.covariance << covariance.xx, covariance.xy, covariance.xz, covariance.xy, covariance.yy,
        covariance.yz, covariance.xz, covariance.yz, covariance.zz;
    const double variance = summary.meanVariance;
    fix.dop = {std::sqrt((covariance.xx + covariance.yy) / variance), std::sqrt(covariance.zz / variance)};
}

UwbFix fixAtHeight(const RangeResiduals& residuals, AnchorRanges ranges, const RangeFixSettings& settings)
{
    UwbFix fix;
    fix.status = FixStatus::Ok;
    const double z = settings.height->z_m;
    Vec3 start;
    if (settings.start)
        start = {settings.start->x(), settings.start->y(), z};
    else if (!planarStart(ranges, z, start)) {
        fix.status = FixStatus::CollinearAnchors;
        return fix;
    }
    if (settings.height->sd_m > 0.0)
        conclude<3>(residuals, descend<3>(residuals, start), fix);
    else
        conclude<2>(residuals, descend<2>(residuals, start), fix);
    return fix;
}

UwbFix fixInSpace(const RangeResiduals& residuals, AnchorRanges ranges, const RangeFixSettings& settings)
{
    UwbFix fix;
    fix.status = FixStatus::Ok;
    if (settings.start) {
        conclude<3>(residuals,
                    descend<3>(residuals, {settings.start->x(), settings.start->y(), settings.start->z()}),
                    fix);
        return fix;
    }
    SpatialStarts starts;
    if (!spatialStarts(ranges, starts)) {
        fix.status = FixStatus::CollinearAnchors;
        return fix;
    }
    Minimum first = descend<3>(residuals, starts.lower);
    if (settings.side == TagSide::Below) {
        conclude<3>(residuals, first, fix);
        return fix;
    }
    Minimum second = descend<3>(residuals, starts.upper);
    fix.iterations = second.iterations;
    if (second.settled && (!first.settled || second.cost < first.cost))
        std::swap(first, second);
    const Eigen::Vector3d apart = toEigen(first.at) - toEigen(second.at);
    fix.mirrored =
        first.settled && second.settled && 2.0 * (second.cost - first.cost) < kSameFit && apart.norm() > 1e-3;
    if (fix.mirrored)
        fix.mirror = toEigen(second.at);
    conclude<3>(residuals, first, fix);
    return fix;
}

} // namespace

UwbFix fixFromRanges(AnchorRanges ranges, const RangeFixSettings& settings)
{
    UwbFix fix;
    fix.status = checkRanges(ranges, 3);
    const bool finite =
        (!settings.height || (std::isfinite(settings.height->z_m) && settings.height->sd_m >= 0.0 &&
                              std::isfinite(settings.height->sd_m))) &&
        (!settings.start || settings.start->allFinite());
    if (fix.ok() && !finite)
        fix.status = FixStatus::BadInput;
    if (!fix.ok())
        return fix;
    const RangeResiduals residuals(ranges, settings.height, settings.huber);
    return settings.height ? fixAtHeight(residuals, ranges, settings)
                           : fixInSpace(residuals, ranges, settings);
}

} // namespace agv::estimation
