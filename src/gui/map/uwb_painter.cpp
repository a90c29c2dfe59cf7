// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/uwb_painter.h"

#include "model/uncertainty.h"

#include <QPainter>
#include <QPolygonF>

#include <algorithm>

namespace agv::gui {
namespace {

constexpr double mapAnchorSize_px = 7.0;
constexpr double crossSize_px = 5.0;

void paintTrail(QPainter& painter, const Viewport& viewport, const std::deque<Point2>& trail,
                const Theme& theme)
{
    QPolygonF line;
    line.reserve(static_cast<qsizetype>(trail.size()));
    for (const Point2 point : trail)
        line << viewport.toPixels(point);
    QColor colour = theme.estimate;
    colour.setAlpha(110);
    painter.setPen(QPen(colour, 1.2));
    painter.drawPolyline(line);
}

void paintUncertainty(QPainter& painter, const Viewport& viewport, const UwbTagSnapshot& tag,
                      const Theme& theme)
{
    const model::Ellipse95 ellipse = model::ellipse95(tag.covariance);
    QColor tint = theme.estimate;
    tint.setAlpha(50);
    painter.save();
    painter.translate(viewport.toPixels(*tag.position));
    painter.rotate(-degFromRad(ellipse.angle));
    painter.setPen(QPen(theme.estimate, 1.0));
    painter.setBrush(tint);
    painter.drawEllipse(QPointF(), viewport.toPixels(ellipse.major_m), viewport.toPixels(ellipse.minor_m));
    painter.restore();
}

void paintMark(QPainter& painter, QPointF at, const QString& label, const Theme& theme)
{
    painter.setPen(QPen(theme.estimate, 2.0));
    painter.drawLine(at - QPointF(crossSize_px, 0.0), at + QPointF(crossSize_px, 0.0));
    painter.drawLine(at - QPointF(0.0, crossSize_px), at + QPointF(0.0, crossSize_px));
    painter.setPen(theme.text);
    painter.drawText(at + QPointF(crossSize_px + 2.0, -crossSize_px), label);
}

} // namespace

void UwbTrails::add(const PlantSnapshot& snapshot)
{
    static const std::vector<UwbTagSnapshot> none;
    const std::vector<UwbTagSnapshot>& tags = snapshot.uwb ? snapshot.uwb->tags : none;
    std::erase_if(m_trails, [&](const auto& entry) {
        return std::ranges::find(tags, entry.first, &UwbTagSnapshot::id) == tags.end();
    });
    for (const UwbTagSnapshot& tag : tags) {
        if (!tag.position)
            continue;
        std::deque<Point2>& trail = m_trails[tag.id];
        if (!trail.empty() && distance(trail.back(), *tag.position) < spacing_m)
            continue;
        trail.push_back(*tag.position);
        if (trail.size() > mostPoints)
            trail.pop_front();
    }
}

const std::deque<Point2>& UwbTrails::of(int tag) const
{
    static const std::deque<Point2> none;
    const auto found = m_trails.find(tag);
    return found == m_trails.end() ? none : found->second;
}

void paintUwbAnchors(QPainter& painter, const Viewport& viewport, const PlantLayout& plant,
                     const Theme& theme)
{
    for (const UwbAnchor& anchor : plant.anchors) {
        if (!anchor.shown)
            continue;
        const QPointF at = viewport.toPixels(Point2{anchor.x, anchor.y});
        const double size = mapAnchorSize_px;
        painter.setPen(QPen(theme.stationEdge, 1.4));
        painter.setBrush(theme.raised);
        painter.drawPolygon(QPolygonF{at + QPointF(0.0, -size), at + QPointF(size, 0.8 * size),
                                      at + QPointF(-size, 0.8 * size)});
        painter.setPen(theme.mutedText);
        painter.drawText(at + QPointF(size + 2.0, size), QString::fromStdString(anchor.label));
    }
}

void paintUwbTags(QPainter& painter, const Viewport& viewport, const UwbSnapshot& uwb,
                  const UwbTrails& trails, const Theme& theme)
{
    painter.save();
    painter.setBrush(Qt::NoBrush);
    for (const UwbTagSnapshot& tag : uwb.tags)
        paintTrail(painter, viewport, trails.of(tag.id), theme);
    for (const UwbTagSnapshot& tag : uwb.tags) {
        if (!tag.position)
            continue;
        paintUncertainty(painter, viewport, tag, theme);
        const QString label =
            tag.label.empty() ? QStringLiteral("T%1").arg(tag.id) : QString::fromStdString(tag.label);
        paintMark(painter, viewport.toPixels(*tag.position), label, theme);
    }
    painter.restore();
}

} // namespace agv::gui
