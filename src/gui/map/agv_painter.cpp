// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/agv_painter.h"

#include <QPainter>

#include <cmath>

namespace agv::gui {
namespace {

constexpr double detailRadius_px = 60.0; ///< from this size on an AGV is a drawing, not a symbol

QPolygonF polygon(const Viewport& viewport, const Pose2& pose, std::initializer_list<Point2> corners)
{
    QPolygonF result;
    for (Point2 corner : corners)
        result << viewport.toPixels(fromVehicleFrame(pose, corner));
    return result;
}

QPolygonF arrow(const Viewport& viewport, const Pose2& pose, double radius)
{
    return polygon(viewport, pose,
                   {{0.82 * radius, 0.0},
                    {0.30 * radius, 0.36 * radius},
                    {0.42 * radius, 0.0},
                    {0.30 * radius, -0.36 * radius}});
}

void paintWheels(QPainter& painter, const Viewport& viewport, const AgvMark& mark, const Theme& theme)
{
    const double side = 0.5 * mark.config->track_m;
    const double half = 0.20 * mark.config->radius_m;
    const double thick = 0.05 * mark.config->radius_m;
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.agvEdge);
    for (double y : {side, -side})
        painter.drawPolygon(
            polygon(viewport, mark.pose,
                    {{half, y + thick}, {-half, y + thick}, {-half, y - thick}, {half, y - thick}}));
}

void paintAntenna(QPainter& painter, const Viewport& viewport, const AgvMark& mark, double readingRange_m,
                  const Theme& theme)
{
    const QPointF antenna = viewport.toPixels(fromVehicleFrame(mark.pose, mark.config->antenna));
    const double range = viewport.toPixels(readingRange_m);
    QColor tint = theme.estimate;
    tint.setAlpha(theme.dark ? 26 : 18);
    painter.setPen(QPen(theme.estimate, 1.0, Qt::DotLine));
    painter.setBrush(tint);
    painter.drawEllipse(antenna, range, range);
    painter.setPen(QPen(theme.agvEdge, 1.2));
    painter.setBrush(theme.raised);
    const double half = std::max(2.0, viewport.toPixels(0.018));
    painter.drawRect(QRectF(antenna - QPointF(half, half), QSizeF(2.0 * half, 2.0 * half)));
}

// Small: the number stands on the AGV. Large: its name stands beside it, clear of what the turn found.
void paintName(QPainter& painter, const Viewport& viewport, const AgvMark& mark, const Theme& theme)
{
    const double radius = viewport.toPixels(mark.config->radius_m);
    const QPointF centre = viewport.toPixels(mark.pose.position);
    QFont font = painter.font();
    font.setBold(true);
    if (radius < detailRadius_px) {
        font.setPixelSize(static_cast<int>(std::clamp(0.62 * radius, 10.0, 30.0)));
        painter.setFont(font);
        painter.setPen(theme.text);
        painter.drawText(QRectF(centre - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius)),
                         Qt::AlignCenter, QString::number(mark.config->id.number));
        return;
    }
    painter.setFont(font);
    const QString name = QString::fromStdString(mark.config->name);
    const QFontMetricsF metrics(font);
    QRectF plate(0.0, 0.0, metrics.horizontalAdvance(name) + 14.0, metrics.height() + 6.0);
    plate.moveBottomRight(centre + QPointF(-0.74 * radius, -0.74 * radius));
    painter.setPen(QPen(mark.selected ? theme.estimate : theme.agvEdge, 1.2));
    painter.setBrush(theme.raised);
    painter.drawRoundedRect(plate, 4.0, 4.0);
    painter.setPen(theme.text);
    painter.drawText(plate, Qt::AlignCenter, name);
}

void paintWarning(QPainter& painter, QPointF at, const QString& sign, const Theme& theme)
{
    const QPolygonF triangle{at + QPointF(0, -11), at + QPointF(11, 8), at + QPointF(-11, 8)};
    painter.setPen(QPen(theme.raised, 1.5, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(theme.warning);
    painter.drawPolygon(triangle);
    QFont font = painter.font();
    font.setPixelSize(12);
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(theme.raised);
    painter.drawText(QRectF(at - QPointF(11, 9), QSizeF(22, 19)), Qt::AlignCenter, sign);
}

} // namespace

void paintAgv(QPainter& painter, const Viewport& viewport, const AgvMark& mark, double readingRange_m,
              const Theme& theme)
{
    painter.save();
    const QPointF centre = viewport.toPixels(mark.pose.position);
    const double radius = viewport.toPixels(mark.config->radius_m);
    paintAntenna(painter, viewport, mark, readingRange_m, theme);

    QColor body = theme.agvBody;
    body.setAlpha(mark.certainty == PoseCertainty::Known ? 210 : 90);
    const bool tentative = mark.certainty != PoseCertainty::Known;
    painter.setPen(QPen(mark.selected ? theme.estimate : theme.agvEdge, mark.selected ? 2.4 : 1.6,
                        tentative ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(body);
    painter.drawEllipse(centre, radius, radius);
    paintWheels(painter, viewport, mark, theme);
    painter.setPen(Qt::NoPen);
    painter.setBrush(mark.selected ? theme.estimate : theme.agvEdge);
    painter.drawPolygon(arrow(viewport, mark.pose, mark.config->radius_m));
    paintName(painter, viewport, mark, theme);
    const QPointF corner = centre + QPointF(0.75 * radius, -0.75 * radius);
    if (mark.mayBeMoving)
        paintWarning(painter, corner, QStringLiteral("!"), theme);
    else if (mark.certainty == PoseCertainty::Doubted)
        paintWarning(painter, corner, QStringLiteral("?"), theme);
    painter.restore();
}

void paintAlternative(QPainter& painter, const Viewport& viewport, const AgvConfig& config, const Pose2& pose,
                      const Theme& theme)
{
    painter.save();
    const QPointF centre = viewport.toPixels(pose.position);
    const double radius = viewport.toPixels(config.radius_m);
    painter.setPen(QPen(theme.alternative, 1.8, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, radius, radius);
    painter.drawPolygon(arrow(viewport, pose, config.radius_m));
    // The label stands behind the vehicle, clear of its arrow.
    const QPointF label = viewport.toPixels(fromVehicleFrame(pose, {-1.25 * config.radius_m, 0.0}));
    painter.setPen(theme.alternative);
    painter.drawText(QRectF(label - QPointF(30, 10), QSizeF(60, 20)), Qt::AlignCenter, QStringLiteral("2?"));
    painter.restore();
}

} // namespace agv::gui
