// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/minimap.h"

#include <QPainter>

#include <algorithm>

namespace agv::gui {
namespace {

constexpr double minimapSide_px = 132.0;
constexpr double minimapMargin_px = 12.0;
constexpr double smallestMap_px = 3.0 * minimapSide_px;

} // namespace

std::optional<QRectF> Minimap::place(const Viewport& viewport, const QRectF& area) const
{
    const QSizeF size = viewport.size();
    if (std::min(size.width(), size.height()) < smallestMap_px || area.isEmpty() ||
        viewport.visibleArea().contains(area))
        return std::nullopt;
    const double scale = minimapSide_px / std::max(area.width(), area.height());
    const QSizeF own(scale * area.width() + 10.0, scale * area.height() + 10.0);
    return QRectF(QPointF(size.width() - own.width() - minimapMargin_px, minimapMargin_px), own);
}

Viewport Minimap::inner(const QRectF& place, const QRectF& area)
{
    Viewport viewport;
    viewport.setSize(place.size());
    viewport.fit(area, {5.0, 5.0, 5.0, 5.0});
    return viewport;
}

std::optional<Point2> Minimap::plantPointAt(QPointF pixel, const Viewport& viewport, const QRectF& area) const
{
    const std::optional<QRectF> own = place(viewport, area);
    if (!own || !own->contains(pixel))
        return std::nullopt;
    return inner(*own, area).toPlant(pixel - own->topLeft());
}

void Minimap::paint(QPainter& painter, const Viewport& viewport, const PlantLayout& plant, const QRectF& area,
                    const PlantSnapshot& snapshot, const Theme& theme) const
{
    const std::optional<QRectF> own = place(viewport, area);
    if (!own)
        return;
    const Viewport small = inner(*own, area);
    const auto rectangle = [&small](const QRectF& r) {
        return QRectF(small.toPixels(Point2{r.left(), r.bottom()}),
                      small.toPixels(Point2{r.right(), r.top()}));
    };
    painter.save();
    painter.setPen(QPen(theme.strongBorder, 1.0));
    painter.setBrush(theme.panel);
    painter.drawRect(*own);
    painter.setClipRect(*own, Qt::IntersectClip);
    painter.translate(own->topLeft());
    painter.fillRect(rectangle(QRectF(plant.origin.x, plant.origin.y, plant.width_m, plant.height_m)),
                     theme.mapFloor);
    for (const Station& station : plant.stations) {
        const QPointF at = small.toPixels(station.pose.position);
        painter.fillRect(QRectF(at - QPointF(2.5, 2.5), QSizeF(5.0, 5.0)), theme.stationEdge);
    }
    for (const AgvSnapshot& agv : snapshot.agvs) {
        if (!agv.pose)
            continue;
        painter.setPen(QPen(theme.agvEdge, 1.2));
        painter.setBrush(theme.agvBody);
        painter.drawEllipse(small.toPixels(agv.pose->position), 4.0, 4.0);
    }
    painter.setPen(QPen(theme.accent, 1.6));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rectangle(viewport.visibleArea()));
    painter.restore();
}

} // namespace agv::gui
