// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"
#include "model/floor_tag_states.h"

#include <vector>

class QPainter;

namespace agv::gui {

/// Marks on the floor tags: dots for tags that were seen, crossed squares for missing ones, triangles with a
/// question mark for unknown ones.
void paintFloorTagMarks(QPainter& painter, const Viewport& viewport, const model::FloorTagStates& states,
                        const std::vector<FloorTag>& tags, double tagRadius_m, const Theme& theme);

} // namespace agv::gui
