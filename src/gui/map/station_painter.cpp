// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/station_painter.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace agv::gui {
namespace {

QPainterPath drop(QPointF c, double r)
{
    QPainterPath path(c - QPointF(0, r));
    path.cubicTo(c + QPointF(0.4 * r, -0.4 * r), c + QPointF(0.75 * r, 0), c + QPointF(0.7 * r, 0.35 * r));
    path.cubicTo(c + QPointF(0.6 * r, r), c + QPointF(-0.6 * r, r), c + QPointF(-0.7 * r, 0.35 * r));
    path.cubicTo(c + QPointF(-0.75 * r, 0), c + QPointF(-0.4 * r, -0.4 * r), c - QPointF(0, r));
    return path;
}

QPainterPath bolt(QPointF c, double r)
{
    QPainterPath path;
    path.addPolygon(QPolygonF{c + QPointF(0.25 * r, -r), c + QPointF(-0.55 * r, 0.15 * r),
                              c + QPointF(-0.05 * r, 0.15 * r), c + QPointF(-0.25 * r, r),
                              c + QPointF(0.55 * r, -0.2 * r), c + QPointF(0.05 * r, -0.2 * r)});
    path.closeSubpath();
    return path;
}

QPainterPath shelves(QPointF c, double r)
{
    QPainterPath path;
    for (double y : {-0.8, -0.15, 0.5})
        path.addRoundedRect(QRectF(c.x() - 0.8 * r, c.y() + y * r, 1.6 * r, 0.4 * r), 1.0, 1.0);
    return path;
}

QPainterPath stirrer(QPointF c, double r)
{
    QPainterPath path;
    path.addEllipse(c + QPointF(-0.5 * r, 0.4 * r), 0.45 * r, 0.3 * r);
    path.addEllipse(c + QPointF(0.5 * r, 0.4 * r), 0.45 * r, 0.3 * r);
    path.addRect(QRectF(c.x() - 0.08 * r, c.y() - r, 0.16 * r, 1.4 * r));
    return path;
}

QPainterPath symbolOf(StationKind kind, QPointF c, double r)
{
    switch (kind) {
    case StationKind::Colour:
        return drop(c, r);
    case StationKind::Mixing:
        return stirrer(c, r);
    case StationKind::Storage:
        return shelves(c, r);
    case StationKind::Charging:
        return bolt(c, r);
    case StationKind::Other:
        break;
    }
    QPainterPath path;
    path.addEllipse(c, 0.4 * r, 0.4 * r);
    return path;
}

QPolygonF outlineOf(const Viewport& viewport, const Station& station)
{
    const double w = 0.5 * station.width_m;
    const double d = 0.5 * station.depth_m;
    QPolygonF outline;
    for (Point2 corner : {Point2{w, d}, Point2{-w, d}, Point2{-w, -d}, Point2{w, -d}})
        outline << viewport.toPixels(fromVehicleFrame(station.pose, corner));
    return outline;
}

QRectF boxOf(const Viewport& viewport, const Station& station)
{
    return outlineOf(viewport, station).boundingRect();
}

double symbolRadius(const QRectF& box) { return std::min({0.22 * box.width(), 0.22 * box.height(), 14.0}); }

/// Symbol and name one below the other, when the station is large enough for both.
bool holdsName(const QRectF& box, QSizeF name)
{
    return box.height() > 2.0 * symbolRadius(box) + name.height() + 6.0 && box.width() > name.width();
}

QPointF symbolCentre(const QRectF& box, QSizeF name)
{
    return box.center() - QPointF(0.0, holdsName(box, name) ? 0.5 * name.height() : 0.0);
}

QSizeF nameSize(const QFontMetricsF& metrics, const Station& station)
{
    return {metrics.horizontalAdvance(QString::fromStdString(station.name)) + 8.0, metrics.height()};
}

/// Where the name may stand, best first: inside, beside it towards the middle of the plant, on the other
/// sides.
std::vector<QRectF> placesFor(const QRectF& box, QSizeF name, QPointF plantCentre)
{
    const auto at = [name](QPointF centre) {
        return QRectF(centre - QPointF(0.5 * name.width(), 0.5 * name.height()), name);
    };
    const QPointF inward = plantCentre - box.center();
    const double side = inward.x() > 0.0 ? 1.0 : -1.0;
    const double end = inward.y() > 0.0 ? 1.0 : -1.0;
    const QPointF across(side * (0.5 * box.width() + 0.5 * name.width() + 3.0), 0.0);
    const QPointF along(0.0, end * (0.5 * box.height() + 0.5 * name.height() + 3.0));
    const bool acrossFirst = std::abs(inward.x()) > std::abs(inward.y());
    const QPointF first = acrossFirst ? across : along;
    const QPointF second = acrossFirst ? along : across;
    std::vector<QRectF> places;
    if (holdsName(box, name))
        places.push_back(at(
            {box.center().x(), symbolCentre(box, name).y() + symbolRadius(box) + 2.0 + 0.5 * name.height()}));
    for (const QPointF offset : {first, second, -second, -first})
        places.push_back(at(box.center() + offset));
    return places;
}

bool isFree(const QRectF& place, const std::vector<QRectF>& obstacles)
{
    return std::ranges::none_of(obstacles,
                                [&place](const QRectF& obstacle) { return obstacle.intersects(place); });
}

} // namespace

void paintStation(QPainter& painter, const Viewport& viewport, const Station& station, const Theme& theme)
{
    const QPolygonF outline = outlineOf(viewport, station);
    painter.setPen(QPen(theme.stationEdge, 1.3));
    painter.setBrush(theme.station);
    painter.drawPolygon(outline);
    const QRectF box = outline.boundingRect();
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.mutedText);
    const QPointF middle = symbolCentre(box, nameSize(QFontMetricsF(painter.font()), station));
    painter.drawPath(symbolOf(station.kind, middle, symbolRadius(box)));
}

std::vector<QRectF> placeStationNames(const QFontMetricsF& metrics, const Viewport& viewport,
                                      const PlantLayout& plant, const QRectF& visible,
                                      const std::vector<QRectF>& taken)
{
    const QPointF centre =
        viewport.toPixels(plant.origin + Point2{0.5 * plant.width_m, 0.5 * plant.height_m});
    std::vector<QRectF> boxes;
    for (const Station& station : plant.stations)
        boxes.push_back(boxOf(viewport, station));
    std::vector<QRectF> names;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        std::vector<QRectF> obstacles = taken;
        obstacles.insert(obstacles.end(), names.begin(), names.end());
        for (std::size_t other = 0; other < boxes.size(); ++other)
            if (other != i)
                obstacles.push_back(boxes[other]);
        const std::vector<QRectF> places = placesFor(boxes[i], nameSize(metrics, plant.stations[i]), centre);
        const auto free = std::ranges::find_if(
            places, [&](const QRectF& place) { return visible.contains(place) && isFree(place, obstacles); });
        names.push_back(free != places.end() ? *free : places.front());
    }
    return names;
}

void paintStationNames(QPainter& painter, const Viewport& viewport, const PlantLayout& plant,
                       const std::vector<QRectF>& places, const Theme& theme)
{
    QColor plate = theme.mapFloor;
    plate.setAlpha(215);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Station& station = plant.stations[i];
        if (!boxOf(viewport, station).contains(places[i])) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(plate);
            painter.drawRoundedRect(places[i], 3.0, 3.0);
        }
        painter.setPen(theme.mutedText);
        painter.drawText(places[i], Qt::AlignCenter, QString::fromStdString(station.name));
    }
}

} // namespace agv::gui
