// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/snapshot.h"

namespace agv::model {

/// Chi-square with two degrees of freedom at 95 %: scale of the 95 % ellipse, -2 ln 0.05.
inline constexpr double chiSquare95TwoDof = 5.991464547107979;
/// Two-sided 95 % quantile of the normal distribution.
inline constexpr double normal95 = 1.959963984540054;

/// Half axes in m and direction of the long one (rad, counter-clockwise from +x, (-pi/2, pi/2]) of the
/// region that holds the position with 95 % probability.
struct Ellipse95 {
    double major_m = 0.0;
    double minor_m = 0.0;
    double angle = 0.0;
};

/// From the position block of `covariance`; eigenvalues of a symmetric 2x2 matrix in closed form. A block
/// that is not positive semi-definite is clamped to zero.
Ellipse95 ellipse95(const PoseCovariance& covariance);
Ellipse95 ellipse95(const PositionCovariance& covariance);

} // namespace agv::model
