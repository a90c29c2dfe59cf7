// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/fix.h"

namespace agv::estimation {

/// Linear least squares of the squared ranges, unknowns (x, y, R = x^2 + y^2), unweighted: thesis equations
/// 5.5 and 5.6. The anchors' heights count as zero unless the tag's height is given: then the ranges are
/// first reduced to the floor, r'^2 = r^2 - (z_tag - z_anchor)^2. Three ranges or more.
UwbFix linearToa2d(AnchorRanges ranges, std::optional<TagHeight> height = {});

/// The same in space, unknowns z_a = (x, y, z, R): thesis equations 5.19 to 5.23 with the last row of 5.22
/// corrected to -2 Z_M. Four ranges or more from anchors that do not lie in one plane.
struct LinearToa3d {
    UwbFix fix;
    Eigen::Vector4d unknowns = Eigen::Vector4d::Zero(); ///< z_a; m, m, m, m^2
};
LinearToa3d linearToa3d(AnchorRanges ranges);

} // namespace agv::estimation
