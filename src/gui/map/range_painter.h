// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

class QPainter;

namespace agv::gui {

/// The radius on the plan, m, of the places at this range from the anchor for a tag at height `z_m`; 0 when
/// the range is shorter than the difference in height.
double radiusOnPlan(const UwbAnchor& anchor, double range_m, double z_m);

/// The ranges of a tag: a circle about each anchor, dashed where the way was obstructed, and beside the
/// anchor in words whether the way was clear and by how much the range misses the position.
void paintRanges(QPainter& painter, const Viewport& viewport, const UwbTagSnapshot& tag,
                 const std::vector<UwbAnchor>& anchors, const Theme& theme);

} // namespace agv::gui
