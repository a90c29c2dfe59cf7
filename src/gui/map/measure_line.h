// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/geometry.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

class QPainter;

namespace agv::gui {

/// A distance on the plan between two points, m in the plant frame.
struct MeasureLine {
    Point2 from;
    Point2 to;

    /// "1,204 mm, 92.3°": length, and direction from `from` counter-clockwise from +x.
    QString summary() const;
    /// The parts along x and y.
    QString parts() const;
};

void paintMeasureLine(QPainter& painter, const Viewport& viewport, const MeasureLine& line,
                      const Theme& theme);

} // namespace agv::gui
