// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/anchor_range.h"

#include <cstdint>
#include <Eigen/Core>
#include <optional>

namespace agv::estimation {

/// Least share of the largest pivot that counts as a rank; rounding leaves about 1e-16.
inline constexpr double kRankThreshold = 1e-9;

enum class FixStatus : std::uint8_t {
    Ok,
    BadInput,         ///< a range, anchor or standard deviation is not finite or not positive
    TooFewRanges,     ///< fewer ranges than unknowns
    TooManyRanges,    ///< more than kMaxAnchors
    CollinearAnchors, ///< the anchors stand on one line: the tag may be on either side of it
    CoplanarAnchors,  ///< a linear 3-D solution needs anchors at different heights
    SingularWeights,  ///< the weights of the second step vanish: a coordinate is zero
    UnseenDirection,  ///< no range changes when the tag moves in some direction
    NoIntersection,   ///< the hyperbolas or bearings do not meet
    ParallelBearings, ///< the bearings are parallel
    Diverged,         ///< the iteration did not settle
};

/// What is wrong and what to do about it, for logs and the tag list.
const char* toText(FixStatus status);

/// Expected accuracy in units of the range accuracy (dilution of precision).
struct Dop {
    double horizontal = 0.0; ///< sd of (x, y) over sd of a range
    double vertical = 0.0;   ///< 0 when the height was given exactly
    double position() const;
};

/// Position of a tag from one set of measurements. Every number is finite whatever the status; unless the
/// status is Ok the position means nothing.
struct UwbFix {
    FixStatus status = FixStatus::TooFewRanges;
    bool mirrored = false; ///< a second position explains the ranges nearly as well: see mirror
    int used = 0;          ///< ranges that entered
    int iterations = 0;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< plant frame, m
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero(); ///< m^2, of the given range sds (Cramer-Rao bound)
    Eigen::Vector3d mirror = Eigen::Vector3d::Zero();     ///< only with mirrored
    Dop dop;
    double chiSquared = 0.0; ///< sum of squared residuals over their variances
    double residual_m = 0.0; ///< rms of the residuals

    bool ok() const { return status == FixStatus::Ok; }
    /// Standard deviation of the horizontal position, m.
    double horizontalSd_m() const;
};

/// Inverse of the Fisher information of the ranges at a position: the Cramer-Rao bound of any unbiased
/// estimate. Without `height` three coordinates are unknown; with it the height is known to its sd. Nothing
/// when the ranges do not determine the position.
std::optional<Eigen::Matrix3d> rangeBound(AnchorRanges ranges, const Eigen::Vector3d& position,
                                          std::optional<TagHeight> height = {});

/// Dilution of precision belonging to such a covariance.
Dop dopOf(AnchorRanges ranges, const Eigen::Matrix3d& covariance);

/// Fills in what follows from fix.position: covariance, accuracy, residuals, and the status Ok or
/// UnseenDirection.
void completeFix(UwbFix& fix, AnchorRanges ranges, std::optional<TagHeight> height = {});

/// Ok, or what makes the ranges useless for `unknowns` coordinates before any geometry is looked at.
FixStatus checkRanges(AnchorRanges ranges, int unknowns);

} // namespace agv::estimation
