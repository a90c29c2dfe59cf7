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
constexpr std::ptrdiff_t mostLabels = 200; ///< more would cover each other; the details are under the pointer

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
    if (label.isEmpty())
        return;
    painter.setPen(theme.text);
    painter.drawText(at + QPointF(crossSize_px + 2.0, -crossSize_px), label);
}

} // namespace

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

void paintUwbTags(QPainter& painter, const Viewport& viewport, const UwbSnapshot& uwb, bool withUncertainty,
                  const Theme& theme)
{
    painter.save();
    painter.setBrush(Qt::NoBrush);
    const QRectF visible = viewport.visibleArea();
    const auto isVisible = [&visible](const UwbTagSnapshot& tag) {
        return tag.position && visible.contains(tag.position->x, tag.position->y);
    };
    const bool labelled = std::ranges::count_if(uwb.tags, isVisible) <= mostLabels;
    for (const UwbTagSnapshot& tag : uwb.tags) {
        if (!isVisible(tag))
            continue;
        if (withUncertainty)
            paintUncertainty(painter, viewport, tag, theme);
        const QString label = !labelled           ? QString()
                              : tag.label.empty() ? QStringLiteral("T%1").arg(tag.id)
                                                  : QString::fromStdString(tag.label);
        paintMark(painter, viewport.toPixels(*tag.position), label, theme);
    }
    painter.restore();
}

} // namespace agv::gui
