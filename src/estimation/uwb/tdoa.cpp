// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/tdoa.h"

#include <array>
#include <cmath>
#include <Eigen/LU>
#include <Eigen/QR>

namespace agv::estimation {

namespace {

/// Two roots fit alike when their chi-squared differ by less.
constexpr double kSameFit = 1.0;

using DifferenceRows = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, kMaxAnchors, 2>;
using TdoaColumns = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, kMaxAnchors, 2>;
using Differences = std::span<const RangeDifference>;

FixStatus check(Differences anchors, double height_m)
{
    if (anchors.size() > kMaxAnchors)
        return FixStatus::TooManyRanges;
    bool finite = std::isfinite(height_m);
    for (const RangeDifference& a : anchors)
        finite = finite && a.anchor.allFinite() && std::isfinite(a.difference_m) && a.sd_m > 0.0 &&
                 std::isfinite(a.sd_m);
    if (!finite)
        return FixStatus::BadInput;
    return anchors.size() < 3 ? FixStatus::TooFewRanges : FixStatus::Ok;
}

/// Sum of squared errors of the differences, each over the variance of both of its arrival times.
double misfit(Differences anchors, const Eigen::Vector3d& position)
{
    double sum = 0.0;
    const double first = (position - anchors[0].anchor).norm();
    for (const RangeDifference& a : anchors.subspan(1)) {
        const double error = a.difference_m - ((position - a.anchor).norm() - first);
        sum += error * error / (a.sd_m * a.sd_m + anchors[0].sd_m * anchors[0].sd_m);
    }
    return sum;
}

/// Cramer-Rao bound of (x, y): the unknown time of departure is projected out of the arrival times.
std::optional<Eigen::Matrix2d> bound(Differences anchors, const Eigen::Vector3d& position)
{
    Eigen::Matrix2d outer = Eigen::Matrix2d::Zero();
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    double weights = 0.0;
    for (const RangeDifference& a : anchors) {
        const Eigen::Vector3d away = position - a.anchor;
        const double d = away.norm();
        if (!(d > 0.0))
            continue;
        const Eigen::Vector2d u = away.head<2>() / d;
        const double w = 1.0 / (a.sd_m * a.sd_m);
        outer += w * u * u.transpose();
        mean += w * u;
        weights += w;
    }
    const Eigen::Matrix2d information = outer - mean * mean.transpose() / weights;
    if (!(information.determinant() > 1e-12 * information.trace() * information.trace()))
        return {};
    return information.inverse();
}

/// Non-negative roots of a r^2 + 2 b r + c, and how many.
int roots(double a, double b, double c, std::array<double, 2>& found)
{
    int n = 0;
    const auto keep = [&](double r) {
        if (std::isfinite(r) && r >= 0.0)
            found[static_cast<std::size_t>(n++)] = r;
    };
    if (std::abs(a) < 1e-12) {
        if (b != 0.0)
            keep(-0.5 * c / b);
        return n;
    }
    const double discriminant = b * b - a * c;
    // Noise pushes a double root, the tag behind an anchor, below zero: nearly zero counts as zero.
    if (discriminant < -1e-3 * b * b)
        return 0;
    const double root = std::sqrt(std::max(discriminant, 0.0));
    keep((-b + root) / a);
    keep((-b - root) / a);
    return n;
}

} // namespace

UwbFix tdoaFix(std::span<const RangeDifference> anchors, double height_m)
{
    UwbFix fix;
    fix.status = check(anchors, height_m);
    if (!fix.ok())
        return fix;
    const Eigen::Vector3d origin = anchors[0].anchor;
    const auto n = static_cast<Eigen::Index>(anchors.size()) - 1;
    const double rise = height_m - origin.z();
    DifferenceRows a(n, 2);
    TdoaColumns bc(n, 2); // B and C of 5.14, relative to the first anchor
    for (Eigen::Index i = 0; i < n; ++i) {
        const RangeDifference& other = anchors[static_cast<std::size_t>(i) + 1];
        const Eigen::Vector3d base = other.anchor - origin;
        a.row(i) = base.head<2>().transpose();
        bc(i, 0) = -other.difference_m;
        bc(i, 1) = 0.5 * (base.squaredNorm() - other.difference_m * other.difference_m) - base.z() * rise;
    }
    Eigen::ColPivHouseholderQR<DifferenceRows> factor(a);
    factor.setThreshold(kRankThreshold);
    if (factor.rank() < 2) {
        fix.status = FixStatus::CollinearAnchors;
        return fix;
    }
    const Eigen::Matrix2d solved = factor.solve(bc); // x - x_1 = column 0 * R_1 + column 1 (5.15)
    const Eigen::Vector2d b = solved.col(0);
    const Eigen::Vector2d c = solved.col(1);
    std::array<double, 2> r1{};
    const int count = roots(b.squaredNorm() - 1.0, b.dot(c), c.squaredNorm() + rise * rise, r1);
    if (count == 0) {
        fix.status = FixStatus::NoIntersection;
        return fix;
    }
    std::array<Eigen::Vector3d, 2> places{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
    std::array<double, 2> error{};
    for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
        places[k] << origin.head<2>() + b * r1[k] + c, height_m;
        error[k] = misfit(anchors, places[k]);
    }
    std::size_t best = 0;
    if (count == 2) {
        Eigen::Vector3d middle = Eigen::Vector3d::Zero();
        for (const RangeDifference& anchor : anchors)
            middle += anchor.anchor / static_cast<double>(anchors.size());
        fix.mirrored = std::abs(error[0] - error[1]) < kSameFit;
        const bool secondNearer = (places[1] - middle).norm() < (places[0] - middle).norm();
        best = (fix.mirrored ? secondNearer : error[1] < error[0]) ? 1 : 0;
        if (fix.mirrored)
            fix.mirror = places[1 - best];
    }
    fix.position = places[best];
    fix.chiSquared = error[best];
    const auto covariance = bound(anchors, fix.position);
    if (!covariance) {
        fix.status = FixStatus::UnseenDirection;
        return fix;
    }
    fix.covariance.topLeftCorner<2, 2>() = *covariance;
    fix.used = static_cast<int>(anchors.size());
    fix.dop.horizontal = fix.horizontalSd_m() / anchors[0].sd_m;
    fix.residual_m = std::sqrt(fix.chiSquared / static_cast<double>(n)) * anchors[0].sd_m;
    return fix;
}

} // namespace agv::estimation
