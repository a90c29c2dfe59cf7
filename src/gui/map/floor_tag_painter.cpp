// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/floor_tag_painter.h"

#include <QPainter>

#include <algorithm>

namespace agv::gui {
namespace {

void paintMissing(QPainter& painter, QPointF at, double half)
{
    const QRectF square(at - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half));
    painter.drawRect(square);
    painter.drawLine(square.topLeft(), square.bottomRight());
    painter.drawLine(square.topRight(), square.bottomLeft());
}

void paintUnknown(QPainter& painter, QPointF at, const Theme& theme)
{
    constexpr double size = 9.0;
    painter.setPen(QPen(theme.warning, 1.6));
    painter.setBrush(theme.raised);
    painter.drawPolygon(
        QPolygonF{at + QPointF(0.0, -size), at + QPointF(size, 0.8 * size), at + QPointF(-size, 0.8 * size)});
    painter.setPen(theme.text);
    painter.drawText(QRectF(at - QPointF(size, 0.65 * size), QSizeF(2.0 * size, 1.6 * size)), Qt::AlignCenter,
                     QStringLiteral("?"));
}

} // namespace

void paintFloorTagMarks(QPainter& painter, const Viewport& viewport, const model::FloorTagStates& states,
                        const std::vector<FloorTag>& tags, double tagRadius_m, const Theme& theme)
{
    const QRectF visible = viewport.visibleArea();
    const double radius = std::max(1.3, viewport.toPixels(tagRadius_m));
    for (const FloorTag& tag : tags) {
        const model::FloorTagState state = states.stateOf(tag.uid);
        if (state == model::FloorTagState::NotSeen || !visible.contains(tag.position.x, tag.position.y))
            continue;
        const QPointF at = viewport.toPixels(tag.position);
        if (state == model::FloorTagState::Missing) {
            painter.setPen(QPen(theme.warning, 1.4));
            painter.setBrush(Qt::NoBrush);
            paintMissing(painter, at, std::max(4.5, 0.8 * radius));
        } else {
            painter.setPen(Qt::NoPen);
            painter.setBrush(theme.mutedText);
            painter.drawEllipse(at, std::max(2.2, 0.5 * radius), std::max(2.2, 0.5 * radius));
        }
    }
    for (const model::FloorTagStates::Unknown& unknown : states.unknown())
        paintUnknown(painter, viewport.toPixels(unknown.antenna), theme);
}

} // namespace agv::gui
