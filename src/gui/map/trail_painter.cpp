// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/trail_painter.h"

#include <QPainter>
#include <QPolygon>

namespace agv::gui {
namespace {

// Whole pixels and a pen of one pixel, not smoothed: the fast way of the raster engine, for a thousand
// trails.
void paintTrail(QPainter& painter, const Viewport& viewport, const Trails::Trail& trail, QPolygon& line)
{
    line.clear();
    const auto flush = [&] {
        if (line.size() > 1)
            painter.drawPolyline(line);
        line.clear();
    };
    for (const TrailPoint& point : trail) {
        if (point.startsAnew)
            flush();
        const QPoint at = viewport.toPixels(point.place).toPoint();
        if (line.isEmpty() || line.back() != at)
            line << at;
    }
    flush();
}

} // namespace

void paintTrails(QPainter& painter, const Viewport& viewport, const PlantSnapshot& snapshot,
                 const Trails& trails, const Theme& theme)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing, false);
    QPolygon line;
    // Opaque: blending would take most of the time.
    painter.setPen(QPen(theme.trail, 0.0));
    if (snapshot.uwb) {
        for (const UwbTagSnapshot& tag : snapshot.uwb->tags)
            paintTrail(painter, viewport, trails.ofTag(tag.id), line);
    }
    painter.setPen(QPen(theme.agvEdge, 0.0));
    for (const AgvSnapshot& agv : snapshot.agvs)
        paintTrail(painter, viewport, trails.ofAgv(agv.id.number), line);
    painter.restore();
}

} // namespace agv::gui
