// SPDX-License-Identifier: GPL-3.0-or-later
#include "estimation/uwb/fix.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace agv::estimation {

namespace {

/// Smallest share of information per direction, relative to the best seen one, that counts as information.
constexpr double kLeastInformation = 1e-12;

} // namespace

const char* toText(FixStatus status)
{
    switch (status) {
    case FixStatus::Ok:
        return "ok";
    case FixStatus::BadInput:
        return "a range, an anchor or a standard deviation is not a positive finite number; check the anchor "
               "list";
    case FixStatus::TooFewRanges:
        return "too few anchors answered; three are needed, four for the linear 3-D solutions";
    case FixStatus::TooManyRanges:
        return "more ranges than the solver handles; remove anchors from the list";
    case FixStatus::CollinearAnchors:
        return "the anchors that answered stand on one line, the tag may be on either side; add an anchor "
               "beside it";
    case FixStatus::CoplanarAnchors:
        return "the anchors lie in one plane; give the height of the tag or move an anchor up or down";
    case FixStatus::SingularWeights:
        return "a coordinate is zero, where the two-step solution has no weights; move the origin of the "
               "plant";
    case FixStatus::UnseenDirection:
        return "the ranges do not change along some direction; give the height of the tag or add an anchor";
    case FixStatus::NoIntersection:
        return "the measurements contradict each other; no point fits them";
    case FixStatus::ParallelBearings:
        return "the bearings are parallel and do not meet";
    case FixStatus::Diverged:
        return "no position fits the ranges; check the anchor list";
    }
    return "unknown";
}

double Dop::position() const { return std::hypot(horizontal, vertical); }

double UwbFix::horizontalSd_m() const { return std::sqrt(covariance(0, 0) + covariance(1, 1)); }

std::optional<Eigen::Matrix3d> rangeBound(AnchorRanges ranges, const Eigen::Vector3d& position,
                                          std::optional<TagHeight> height)
{
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    for (const AnchorRange& range : ranges) {
        const Eigen::Vector3d away = position - range.anchor;
        const double d = away.norm();
        if (d > 0.0)
            information += away * away.transpose() / (d * d * range.sd_m * range.sd_m);
    }
    const bool planar = height && height->sd_m <= 0.0;
    if (height && !planar)
        information(2, 2) += 1.0 / (height->sd_m * height->sd_m);
    if (planar) {
        const Eigen::Matrix2d part = information.topLeftCorner<2, 2>();
        const double determinant = part.determinant();
        if (!(determinant > kLeastInformation * part.trace() * part.trace()))
            return {};
        Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
        covariance.topLeftCorner<2, 2>() = part.inverse();
        return covariance;
    }
    const Eigen::LDLT<Eigen::Matrix3d> factor(information);
    const Eigen::Vector3d pivots = factor.vectorD();
    if (!(pivots.minCoeff() > kLeastInformation * pivots.maxCoeff()))
        return {};
    return factor.solve(Eigen::Matrix3d::Identity());
}

Dop dopOf(AnchorRanges ranges, const Eigen::Matrix3d& covariance)
{
    double information = 0.0;
    for (const AnchorRange& range : ranges)
        information += 1.0 / (range.sd_m * range.sd_m);
    if (ranges.empty())
        return {};
    // The range sd that all of them together would need to carry the same information.
    const double variance = static_cast<double>(ranges.size()) / information;
    return {std::sqrt((covariance(0, 0) + covariance(1, 1)) / variance),
            std::sqrt(covariance(2, 2) / variance)};
}

void completeFix(UwbFix& fix, AnchorRanges ranges, std::optional<TagHeight> height)
{
    const auto bound = rangeBound(ranges, fix.position, height);
    if (!bound) {
        fix.status = FixStatus::UnseenDirection;
        return;
    }
    fix.covariance = *bound;
    fix.dop = dopOf(ranges, *bound);
    fix.used = static_cast<int>(ranges.size());
    fix.chiSquared = 0.0;
    double squares = 0.0;
    for (const AnchorRange& range : ranges) {
        const double residual = range.range_m - (fix.position - range.anchor).norm();
        squares += residual * residual;
        fix.chiSquared += residual * residual / (range.sd_m * range.sd_m);
    }
    fix.residual_m = std::sqrt(squares / static_cast<double>(ranges.size()));
    fix.status = FixStatus::Ok;
}

FixStatus checkRanges(AnchorRanges ranges, int unknowns)
{
    if (ranges.size() > kMaxAnchors)
        return FixStatus::TooManyRanges;
    for (const AnchorRange& range : ranges)
        if (!range.anchor.allFinite() || !(range.range_m >= 0.0 && range.range_m < 1e6) ||
            !(range.sd_m > 0.0 && range.sd_m < 1e6))
            return FixStatus::BadInput;
    return static_cast<int>(ranges.size()) < unknowns ? FixStatus::TooFewRanges : FixStatus::Ok;
}

} // namespace agv::estimation
