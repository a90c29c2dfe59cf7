// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plant_layout.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

class QPainter;

namespace agv::gui {

enum class PoseCertainty {
    Known,     ///< accepted or solved
    Tentative, ///< preview while the AGV still turns: dashed
    Doubted,   ///< it was moved, or nobody knows how it moved: dashed, pale, with a question mark
};

struct AgvMark {
    const AgvConfig* config = nullptr;
    Pose2 pose;
    PoseCertainty certainty = PoseCertainty::Known;
    bool selected = false;
    bool mayBeMoving = false;
};

/// An AGV to scale: body, wheels, arrow towards its front, antenna with its reading range, number.
void paintAgv(QPainter& painter, const Viewport& viewport, const AgvMark& mark, double readingRange_m,
              const Theme& theme);

/// A second explanation of the reads: dashed body, arrow and a "2".
void paintAlternative(QPainter& painter, const Viewport& viewport, const AgvConfig& config, const Pose2& pose,
                      const Theme& theme);

} // namespace agv::gui
