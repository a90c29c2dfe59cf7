// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/two_step_toa.h"

#include <algorithm>
#include <cmath>
#include <Eigen/Dense>

namespace agv::estimation {

namespace {

constexpr double kLargestCondition = 1e15;
constexpr double kLeastRange_m = 1e-6;

using TwoStepRows = Eigen::Matrix<double, Eigen::Dynamic, 4, 0, kMaxAnchors, 4>;
using TwoStepColumn = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMaxAnchors, 1>;

struct FirstStep {
    TwoStepRows g;
    TwoStepColumn h, sd, range;
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, kMaxAnchors> anchors;
    Eigen::Matrix4d information = Eigen::Matrix4d::Zero();

    /// Equation 5.28 with B = diag(distances).
    Eigen::Vector4d solve(const TwoStepColumn& distances)
    {
        const TwoStepColumn weights = (4.0 * distances.array().square() * sd.array().square()).inverse();
        information = g.transpose() * weights.asDiagonal() * g;
        return information.ldlt().solve(g.transpose() * (weights.array() * h.array()).matrix());
    }

    TwoStepColumn distancesTo(const Eigen::Vector3d& position) const
    {
        return (anchors.colwise() - position).colwise().norm().transpose().cwiseMax(kLeastRange_m);
    }
};

FirstStep equations(AnchorRanges ranges, const Eigen::Vector3d& origin)
{
    FirstStep step;
    const auto n = static_cast<Eigen::Index>(ranges.size());
    step.g.resize(n, 4);
    step.h.resize(n);
    step.sd.resize(n);
    step.range.resize(n);
    step.anchors.resize(3, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const AnchorRange& range = ranges[static_cast<std::size_t>(i)];
        step.anchors.col(i) = range.anchor - origin;
        step.range(i) = std::max(range.range_m, kLeastRange_m);
        step.sd(i) = range.sd_m;
        step.g.row(i) << -2.0 * step.anchors.col(i).transpose(), 1.0;
        step.h(i) = range.range_m * range.range_m - step.anchors.col(i).squaredNorm();
    }
    return step;
}

double conditionOf(const Eigen::Matrix4d& symmetric)
{
    const Eigen::Vector4d values =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(symmetric, Eigen::EigenvaluesOnly)
            .eigenvalues()
            .cwiseAbs();
    const double least = values.minCoeff();
    return least > 0.0 ? values.maxCoeff() / least : 2.0 * kLargestCondition;
}

/// Equations 5.34 to 5.38. False when the weights are singular.
bool secondStep(const FirstStep& step, TwoStepToa& result)
{
    const Eigen::Vector4d za = result.second;
    const Eigen::Vector4d b(za(0), za(1), za(2), 0.5);
    const Eigen::Matrix4d covariance = 4.0 * b.asDiagonal() * step.information.inverse() * b.asDiagonal();
    if (!covariance.allFinite() || conditionOf(covariance) > kLargestCondition)
        return false;
    const Eigen::Vector4d inverse = (2.0 * b).cwiseInverse();
    const Eigen::Matrix4d weights = inverse.asDiagonal() * step.information * inverse.asDiagonal();
    Eigen::Matrix<double, 4, 3> g = Eigen::Matrix<double, 4, 3>::Ones();
    g.topRows<3>().setIdentity();
    const Eigen::Vector4d h(za(0) * za(0), za(1) * za(1), za(2) * za(2), za(3));
    const Eigen::Matrix3d normal = g.transpose() * weights * g;
    result.squares = normal.ldlt().solve(g.transpose() * (weights * h));
    return result.squares.allFinite();
}

} // namespace

TwoStepToa twoStepToa(AnchorRanges ranges, const TwoStepSettings& settings)
{
    TwoStepToa result;
    UwbFix& fix = result.fix;
    fix.status = checkRanges(ranges, 4);
    if (!fix.ok())
        return result;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();
    if (settings.originShift_m != 0.0) {
        for (const AnchorRange& range : ranges)
            origin += range.anchor / static_cast<double>(ranges.size());
        origin.array() -= settings.originShift_m;
    }
    FirstStep step = equations(ranges, origin);
    Eigen::ColPivHouseholderQR<TwoStepRows> rank(step.g);
    rank.setThreshold(kRankThreshold);
    if (rank.rank() < 4) {
        fix.status = FixStatus::CoplanarAnchors;
        return result;
    }
    result.first = step.solve(step.range);
    result.second = step.solve(step.distancesTo(result.first.head<3>()));
    if (!secondStep(step, result)) {
        result.squares.setZero();
        fix.status = FixStatus::SingularWeights;
        return result;
    }
    result.negativeSquare = result.squares.minCoeff() < 0.0;
    for (int i = 0; i < 3; ++i)
        fix.position(i) =
            origin(i) + std::copysign(std::sqrt(std::max(result.squares(i), 0.0)), result.second(i));
    completeFix(fix, ranges);
    return result;
}

} // namespace agv::estimation
