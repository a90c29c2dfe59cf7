// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/static_layer.h"

#include "gui/map/accuracy_layer.h"
#include "gui/map/station_painter.h"
#include "gui/map/uwb_painter.h"
#include "model/words.h"

#include <QLocale>
#include <QPainter>

#include <cmath>

namespace agv::gui {
namespace {

constexpr double tickSpacing_px = 74.0;

QRectF pixelRect(const Viewport& viewport, const QRectF& area)
{
    return QRectF(viewport.toPixels({area.left(), area.bottom()}),
                  viewport.toPixels({area.right(), area.top()}));
}

} // namespace

QRectF areaOf(const PlantLayout& plant)
{
    QRectF area(plant.origin.x, plant.origin.y, plant.width_m, plant.height_m);
    const auto hold = [&area](Point2 place) {
        area.setLeft(std::min(area.left(), place.x));
        area.setRight(std::max(area.right(), place.x));
        area.setTop(std::min(area.top(), place.y));
        area.setBottom(std::max(area.bottom(), place.y));
    };
    for (const FloorTag& tag : plant.floorTags)
        hold(tag.position);
    for (const UwbAnchor& anchor : plant.anchors) {
        if (anchor.shown)
            hold({anchor.x, anchor.y});
    }
    return area;
}

void StaticLayer::setPlant(const PlantLayout* plant)
{
    m_plant = plant;
    m_valid = false;
}

void StaticLayer::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_valid = false;
}

void StaticLayer::setFont(const QFont& font)
{
    m_font = font;
    m_valid = false;
}

void StaticLayer::setLayers(const MapLayers& layers)
{
    m_valid = m_valid && layers == m_layers;
    m_layers = layers;
}

const QImage& StaticLayer::image(const Viewport& viewport, double devicePixelRatio)
{
    if (m_valid && viewport == m_viewport && devicePixelRatio == m_ratio)
        return m_image;
    m_viewport = viewport;
    m_ratio = devicePixelRatio;
    const QSize pixels = (viewport.size() * devicePixelRatio).toSize();
    if (m_image.size() != pixels)
        m_image = QImage(pixels, QImage::Format_RGB32);
    m_image.setDevicePixelRatio(devicePixelRatio);
    m_image.fill(m_theme.mapOutside);
    QPainter painter(&m_image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(m_font);
    paint(painter);
    m_valid = true;
    ++m_paintCount;
    return m_image;
}

void StaticLayer::paintAt(QPainter& painter, const Viewport& viewport)
{
    m_valid = m_valid && viewport == m_viewport;
    m_viewport = viewport;
    painter.fillRect(QRectF(QPointF(), viewport.size()), m_theme.mapOutside);
    paint(painter);
}

void StaticLayer::paint(QPainter& painter) const
{
    if (m_plant) {
        paintFloor(painter);
        if (m_layers.floorTags)
            paintFloorTags(painter);
        if (m_layers.stations)
            paintStations(painter);
        paintObstacles(painter);
        if (m_layers.accuracy && !m_plant->anchors.empty())
            paintAccuracy(painter, m_viewport, *m_plant, m_theme);
        if (m_layers.anchors)
            paintUwbAnchors(painter, m_viewport, *m_plant, m_theme);
    }
    paintRulers(painter);
    paintScaleBar(painter);
}

void StaticLayer::paintFloor(QPainter& painter) const
{
    const QRectF area(m_plant->origin.x, m_plant->origin.y, m_plant->width_m, m_plant->height_m);
    const QRectF floor = pixelRect(m_viewport, area);
    painter.fillRect(floor, m_theme.mapFloor);
    if (m_layers.grid) {
        const double step = niceStepBelow(tickSpacing_px / m_viewport.scale() * 2.0);
        painter.setPen(QPen(m_theme.mapGrid, 1.0));
        painter.setRenderHint(QPainter::Antialiasing, false);
        for (double x = std::ceil(area.left() / step) * step; x < area.right(); x += step) {
            const double px = m_viewport.toPixels({x, 0.0}).x();
            painter.drawLine(QPointF(px, floor.top()), QPointF(px, floor.bottom()));
        }
        for (double y = std::ceil(area.top() / step) * step; y < area.bottom(); y += step) {
            const double px = m_viewport.toPixels({0.0, y}).y();
            painter.drawLine(QPointF(floor.left(), px), QPointF(floor.right(), px));
        }
        painter.setRenderHint(QPainter::Antialiasing);
    }
    painter.setPen(QPen(m_theme.mapEdge, 1.6));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(floor);
}

void StaticLayer::paintFloorTags(QPainter& painter) const
{
    const double radius = std::max(1.3, m_viewport.toPixels(m_plant->tagRadius_m));
    const QRectF visible = m_viewport.visibleArea();
    // From here on the size of a tag can be seen: an open ring leaves the grid readable.
    const bool large = radius > 4.0;
    painter.setPen(large ? QPen(m_theme.floorTag, 1.2) : QPen(Qt::NoPen));
    painter.setBrush(large ? QBrush(m_theme.mapFloor) : QBrush(m_theme.floorTag));
    for (const FloorTag& tag : m_plant->floorTags) {
        if (visible.contains(tag.position.x, tag.position.y))
            painter.drawEllipse(m_viewport.toPixels(tag.position), radius, radius);
    }
    if (radius < 13.0)
        return;
    QFont font = m_font;
    font.setPointSizeF(font.pointSizeF() * 0.75);
    painter.setFont(font);
    painter.setPen(m_theme.mutedText);
    for (const FloorTag& tag : m_plant->floorTags) {
        if (!visible.contains(tag.position.x, tag.position.y))
            continue;
        const QPointF at = m_viewport.toPixels(tag.position);
        painter.drawText(QRectF(at.x() - 40.0, at.y() + radius + 1.0, 80.0, 16.0), Qt::AlignHCenter,
                         QString::fromStdString(shortText(tag.uid)));
    }
    painter.setFont(m_font);
}

void StaticLayer::paintStations(QPainter& painter) const
{
    for (const Station& station : m_plant->stations)
        paintStation(painter, m_viewport, station, m_theme);
}

void StaticLayer::paintObstacles(QPainter& painter) const
{
    painter.setPen(QPen(m_theme.stationEdge, 1.2));
    for (const Obstacle& obstacle : m_plant->obstacles) {
        QPolygonF outline;
        for (Point2 corner : obstacle.outline)
            outline << m_viewport.toPixels(corner);
        painter.setBrush(m_theme.obstacle);
        painter.drawPolygon(outline);
        painter.setBrush(QBrush(m_theme.stationEdge, Qt::BDiagPattern));
        painter.drawPolygon(outline);
    }
}

void StaticLayer::paintRulers(QPainter& painter) const
{
    const double width = m_viewport.size().width();
    const double height = m_viewport.size().height();
    const double step = niceStepBelow(tickSpacing_px / m_viewport.scale() * 2.0);
    const QRectF visible = m_viewport.visibleArea();
    QFont font = m_font;
    font.setPointSizeF(font.pointSizeF() * 0.85);
    painter.setFont(font);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.fillRect(QRectF(0, 0, rulerWidth, height), m_theme.panel);
    painter.fillRect(QRectF(0, height - rulerHeight, width, rulerHeight), m_theme.panel);
    painter.setPen(m_theme.border);
    painter.drawLine(QPointF(rulerWidth, 0), QPointF(rulerWidth, height - rulerHeight));
    painter.drawLine(QPointF(rulerWidth, height - rulerHeight), QPointF(width, height - rulerHeight));
    const QLocale locale;
    const auto label = [&](double metres) { return locale.toString(std::round(metres * 1e3), 'f', 0); };
    for (auto i = std::ceil(visible.left() / step); i * step <= visible.right(); i += 1.0) {
        const double px = m_viewport.toPixels({i * step, 0.0}).x();
        if (px < rulerWidth + 2.0 || px > width - 18.0)
            continue;
        painter.setPen(m_theme.strongBorder);
        painter.drawLine(QPointF(px, height - rulerHeight), QPointF(px, height - rulerHeight + 4.0));
        painter.setPen(m_theme.mutedText);
        painter.drawText(QRectF(px - 40.0, height - rulerHeight + 4.0, 80.0, rulerHeight - 5.0),
                         Qt::AlignCenter, label(i * step));
    }
    for (auto i = std::ceil(visible.top() / step); i * step <= visible.bottom(); i += 1.0) {
        const double px = m_viewport.toPixels({0.0, i * step}).y();
        if (px < 8.0 || px > height - rulerHeight - 6.0)
            continue;
        painter.setPen(m_theme.strongBorder);
        painter.drawLine(QPointF(rulerWidth - 4.0, px), QPointF(rulerWidth, px));
        painter.setPen(m_theme.mutedText);
        painter.drawText(QRectF(0.0, px - 10.0, rulerWidth - 7.0, 20.0), Qt::AlignRight | Qt::AlignVCenter,
                         label(i * step));
    }
    painter.setPen(m_theme.mutedText);
    painter.drawText(QRectF(0.0, height - rulerHeight, rulerWidth, rulerHeight), Qt::AlignCenter,
                     model::Words::tr("mm"));
    painter.setFont(m_font);
    painter.setRenderHint(QPainter::Antialiasing);
}

void StaticLayer::paintScaleBar(QPainter& painter) const
{
    const double length = niceStepBelow((scaleBarRoom - 36.0) / m_viewport.scale());
    const double px = m_viewport.toPixels(length);
    const QPointF end(m_viewport.size().width() - 18.0, m_viewport.size().height() - rulerHeight - 16.0);
    const QPointF start = end - QPointF(px, 0.0);
    const QString text = model::Words::millimetres(length, length < 1e-3 ? 1 : 0);
    // Nothing shines through: tags and labels below would make it hard to read.
    painter.setPen(QPen(m_theme.border, 1.0));
    painter.setBrush(m_theme.panel);
    painter.drawRoundedRect(QRectF(start - QPointF(10.0, 24.0), end + QPointF(10.0, 9.0)), 5.0, 5.0);
    painter.setPen(QPen(m_theme.text, 1.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(QPolygonF{start - QPointF(0, 5), start, end, end - QPointF(0, 5)});
    painter.drawText(QRectF(start - QPointF(60.0, 22.0), end + QPointF(60.0, -3.0)), Qt::AlignHCenter, text);
}

} // namespace agv::gui
