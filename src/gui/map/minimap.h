// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>

#include "core/plant_layout.h"
#include "core/snapshot.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

#include <optional>

class QPainter;

namespace agv::gui {

/// The whole plant in the map's upper right corner while the map shows only a part of it: where the part is,
/// and where the AGVs are that it does not show.
class Minimap {
public:
    /// Empty when the viewport shows the whole of `area` (m), or is too small for a map in a map.
    std::optional<QRectF> place(const Viewport& viewport, const QRectF& area) const;
    /// The plant point under `pixel`; empty beside the minimap.
    std::optional<Point2> plantPointAt(QPointF pixel, const Viewport& viewport, const QRectF& area) const;

    void paint(QPainter& painter, const Viewport& viewport, const PlantLayout& plant, const QRectF& area,
               const PlantSnapshot& snapshot, const Theme& theme) const;

private:
    static Viewport inner(const QRectF& place, const QRectF& area);
};

} // namespace agv::gui
