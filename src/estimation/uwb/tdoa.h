// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/fix.h"

#include <span>

namespace agv::estimation {

/// An anchor and how much farther (m, signed) the tag is from it than from the first anchor of the list.
struct RangeDifference {
    Eigen::Vector3d anchor = Eigen::Vector3d::Zero();
    double difference_m = 0.0; ///< R_i - R_1; the first anchor's own is 0
    double sd_m = 0.05;        ///< of the arrival time at this anchor, as a length
};

/// Position from differences of arrival times: thesis equations 5.11 to 5.15. x = A^-1 B R_1 + A^-1 C is put
/// into R_1^2 = |x - x_1|^2, which leaves a quadratic equation in R_1; with more than three anchors A^-1 is
/// the pseudo-inverse. Heights enter as known: the tag's is `height_m`. Of two valid roots the one that fits
/// the differences better is taken, or, when both fit, the one nearer to the middle of the anchors; the other
/// is then in UwbFix::mirror.
UwbFix tdoaFix(std::span<const RangeDifference> anchors, double height_m = 0.0);

} // namespace agv::estimation
