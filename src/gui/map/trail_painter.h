// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gui/map/trails.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

class QPainter;

namespace agv::gui {

/// Thin lines along the trails of all AGVs and UWB tags of the snapshot.
void paintTrails(QPainter& painter, const Viewport& viewport, const PlantSnapshot& snapshot,
                 const Trails& trails, const Theme& theme);

} // namespace agv::gui
