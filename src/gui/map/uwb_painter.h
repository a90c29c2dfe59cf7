// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

class QPainter;

namespace agv::gui {

/// The anchors that the plant file wants shown: a triangle and the label.
void paintUwbAnchors(QPainter& painter, const Viewport& viewport, const PlantLayout& plant,
                     const Theme& theme);

/// Every UWB tag that has a position: a cross, its label or number and, if wanted, the 95 % ellipse.
void paintUwbTags(QPainter& painter, const Viewport& viewport, const UwbSnapshot& uwb, bool withUncertainty,
                  const Theme& theme);

} // namespace agv::gui
