// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/aoa.h"

#include <algorithm>
#include <cmath>
#include <Eigen/LU>

namespace agv::estimation {

namespace {

/// Squared sine of the angle below which bearings count as parallel.
constexpr double kParallel = 1e-12;
constexpr double kLeastBearingDistance_m = 1e-3;

using Angles = std::span<const ArrivalAngle>;

FixStatus check(Angles angles)
{
    if (angles.size() > kMaxAnchors)
        return FixStatus::TooManyRanges;
    for (const ArrivalAngle& a : angles)
        if (!a.anchor.allFinite() || !std::isfinite(a.angle) || !(a.sd > 0.0) || !std::isfinite(a.sd))
            return FixStatus::BadInput;
    return angles.size() < 2 ? FixStatus::TooFewRanges : FixStatus::Ok;
}

Eigen::Vector2d directionOf(const ArrivalAngle& a) { return {std::cos(a.angle), std::sin(a.angle)}; }

struct Lines {
    Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();

    /// The distance of the tag from the line through the anchor is known with the given sd.
    void add(const ArrivalAngle& a, double sd_m)
    {
        const Eigen::Vector2d along = directionOf(a);
        const Eigen::Vector2d normal(-along.y(), along.x());
        const Eigen::Matrix2d outer = normal * normal.transpose() / (sd_m * sd_m);
        information += outer;
        right += outer * a.anchor;
    }

    bool parallel() const
    {
        return !(information.determinant() > kParallel * information.trace() * information.trace());
    }
};

} // namespace

UwbFix aoaFix(std::span<const ArrivalAngle> angles)
{
    UwbFix fix;
    fix.status = check(angles);
    if (!fix.ok())
        return fix;
    Lines lines;
    for (const ArrivalAngle& a : angles)
        lines.add(a, a.sd);
    if (lines.parallel()) {
        fix.status = FixStatus::ParallelBearings;
        return fix;
    }
    Eigen::Vector2d place = lines.information.inverse() * lines.right;
    // An angle's sd is a width that grows with distance: once more with the widths at the first solution.
    Lines weighted;
    for (const ArrivalAngle& a : angles)
        weighted.add(a, a.sd * std::max((a.anchor - place).norm(), kLeastBearingDistance_m));
    if (weighted.parallel()) {
        fix.status = FixStatus::ParallelBearings;
        return fix;
    }
    const Eigen::Matrix2d covariance = weighted.information.inverse();
    place = covariance * weighted.right;
    double squares = 0.0;
    for (const ArrivalAngle& a : angles) {
        const Eigen::Vector2d away = a.anchor - place;
        const Eigen::Vector2d along = directionOf(a);
        if (away.dot(along) < 0.0)
            fix.status = FixStatus::NoIntersection;
        const double across = away.x() * along.y() - away.y() * along.x();
        const double sd_m = a.sd * std::max(away.norm(), kLeastBearingDistance_m);
        squares += across * across;
        fix.chiSquared += across * across / (sd_m * sd_m);
    }
    fix.position << place, 0.0;
    fix.covariance.topLeftCorner<2, 2>() = covariance;
    fix.used = static_cast<int>(angles.size());
    fix.residual_m = std::sqrt(squares / static_cast<double>(angles.size()));
    return fix;
}

} // namespace agv::estimation
