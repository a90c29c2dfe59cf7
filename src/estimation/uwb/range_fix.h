// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/fix.h"

namespace agv::estimation {

/// Which of two mirrored solutions is meant when the height is not known. Anchors in one plane, or nearly,
/// cannot tell a tag below from a tag above.
enum class TagSide : std::uint8_t {
    Below, ///< the tag is below the anchors, as on a vehicle: the usual prior
    Either ///< both starts are iterated; the one that fits better wins, the other is reported
};

struct RangeFixSettings {
    std::optional<TagHeight> height = {};      ///< known height: two unknowns, or three with a prior
    TagSide side = TagSide::Below;             ///< without a height only
    std::optional<Eigen::Vector3d> start = {}; ///< the only start when given (a last fix), m
    double huber = 0.0; ///< residuals beyond this many sds weigh less (Huber); 0: plain least squares
};

/// Nonlinear weighted least squares of any three or more ranges, minimising sum ((r - |p - a|) / sd)^2:
/// damped Gauss-Newton, near the minimum with the exact second derivatives. Starts from the linear solution
/// in the plane of the anchors and, in space, on one or both sides of that plane. The default method: with
/// normal errors it reaches the Cramer-Rao bound wherever one minimum stands out.
UwbFix fixFromRanges(AnchorRanges ranges, const RangeFixSettings& settings = {});

} // namespace agv::estimation
