// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "estimation/uwb/range_residuals.h"

namespace agv::estimation {

/// Start of a fix at known height from the linear equations 5.6, the ranges reduced to the floor. False when
/// the anchors stand on one line as seen from above.
bool planarStart(AnchorRanges ranges, double height_m, Vec3& start);

/// Starts of a fix in space: the foot point in the anchors' best plane from the linear equations, moved to
/// either side of the plane by what the ranges leave over. Anchors well spread in all directions have one
/// linear solution; both starts are then the same. `lower` has the smaller z.
struct SpatialStarts {
    Vec3 lower;
    Vec3 upper;
};

/// False when the anchors stand on one line.
bool spatialStarts(AnchorRanges ranges, SpatialStarts& starts);

} // namespace agv::estimation
