// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "core/turn.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

class QPainter;

namespace agv::gui {

enum class EstimateStage { Preview, Result };

/// What an initialisation turn found: fitted circle, 95 % ellipse of the centre, 95 % wedge of the heading. A
/// preview is dashed, a result solid.
void paintEstimate(QPainter& painter, const Viewport& viewport, const TurnEstimate& estimate,
                   const AgvConfig& config, EstimateStage stage, const Theme& theme);

/// The uncertainty of a pose: 95 % ellipse of the centre, 95 % wedge of the heading.
void paintUncertainty(QPainter& painter, const Viewport& viewport, const Pose2& pose,
                      const PoseCovariance& covariance, const AgvConfig& config, const Theme& theme);

/// Its numbered antenna positions, painted last because the numbers must stay readable. A stop that does not
/// fit (tags missed, unknown or out of place) is a diamond instead of a disc.
void paintStops(QPainter& painter, const Viewport& viewport, const TurnEstimate& estimate,
                const Theme& theme);

} // namespace agv::gui
