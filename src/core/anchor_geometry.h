// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"

#include <optional>
#include <vector>

namespace agv {

/// Largest horizontal dilution of precision that is still called a position.
inline constexpr double worstDilution = 20.0;

/// How the anchors' arrangement magnifies the error of a range at a place on the plan: sqrt(trace((J^T
/// J)^-1)), J the directions from the anchors to the tag, seen in the plane of the tag, whose height above
/// the floor (m) is known. Independent range errors of equal size are assumed (GPS's HDOP without a clock).
/// Empty with fewer than two usable anchors and where the ranges hardly tell a direction (above
/// worstDilution).
std::optional<double> horizontalDilution(const std::vector<UwbAnchor>& anchors, Point2 place,
                                         double height_m);

} // namespace agv
