// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

class QPainter;

namespace agv::gui {

/// Standard deviation of a UWB range that the layer assumes, m: noise and what calibration leaves.
inline constexpr double assumedRangeSd_m = 0.05;

/// Radius, m, that holds about 95 % of the positions that four clear ranges would give at `place`, as the
/// arrangement of the anchors lets expect: twice the distance root mean square. Empty where they cannot tell
/// a position.
std::optional<double> expectedUwbRadius(const PlantLayout& plant, Point2 place);

/// Paints what expectedUwbRadius() says over the floor: darker where positions are worse, with a line where
/// each step begins, hatched where there is no position.
void paintAccuracy(QPainter& painter, const Viewport& viewport, const PlantLayout& plant, const Theme& theme);

/// Explains the shades of paintAccuracy().
void paintAccuracyLegend(QPainter& painter, QPointF upperRight, const Theme& theme);

} // namespace agv::gui
