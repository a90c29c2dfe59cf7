// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/fix.h"

#include <span>

namespace agv::estimation {

/// Direction in which a tag's signal travels when it meets an anchor with an array antenna.
struct ArrivalAngle {
    Eigen::Vector2d anchor = Eigen::Vector2d::Zero(); ///< plant frame, m
    double angle = 0.0;                               ///< alpha: direction tag to anchor, rad from +x
    double sd = 0.05;                                 ///< rad, > 0
};

/// Position from two or more angles of arrival: thesis equations 5.2 and 5.3, T = A_i - R_i (cos alpha_i,
/// sin alpha_i); both lines of the printed equations say cos, the second must be sin. The distances R_i are
/// eliminated; more than two bearings are weighted by distance and sd. NoIntersection: the lines meet behind
/// an anchor.
UwbFix aoaFix(std::span<const ArrivalAngle> angles);

} // namespace agv::estimation
