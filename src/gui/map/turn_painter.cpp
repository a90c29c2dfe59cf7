// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/turn_painter.h"

#include "model/stop_table_model.h"
#include "model/uncertainty.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace agv::gui {
namespace {

void paintWedge(QPainter& painter, const Viewport& viewport, const Pose2& pose, double headingSd,
                double length_m, const Theme& theme)
{
    const double half = std::min(degFromRad(model::normal95 * headingSd), 180.0);
    const double length = viewport.toPixels(length_m);
    const QPointF centre = viewport.toPixels(pose.position);
    QColor tint = theme.estimate;
    tint.setAlpha(theme.dark ? 80 : 60);
    painter.setPen(QPen(theme.estimate, 1.0));
    painter.setBrush(tint);
    painter.drawPie(QRectF(centre - QPointF(length, length), QSizeF(2.0 * length, 2.0 * length)),
                    static_cast<int>(std::lround((degFromRad(pose.heading) - half) * 16.0)),
                    static_cast<int>(std::lround(2.0 * half * 16.0)));
}

void paintEllipse(QPainter& painter, const Viewport& viewport, const Pose2& pose,
                  const PoseCovariance& covariance, const Theme& theme)
{
    const model::Ellipse95 ellipse = model::ellipse95(covariance);
    const QPointF centre = viewport.toPixels(pose.position);
    QColor tint = theme.estimate;
    tint.setAlpha(70);
    painter.save();
    painter.translate(centre);
    painter.rotate(-degFromRad(ellipse.angle));
    painter.setPen(QPen(theme.estimate, 1.8));
    painter.setBrush(tint);
    painter.drawEllipse(QPointF(), viewport.toPixels(ellipse.major_m), viewport.toPixels(ellipse.minor_m));
    painter.restore();
}

} // namespace

void paintEstimate(QPainter& painter, const Viewport& viewport, const TurnEstimate& estimate,
                   const AgvConfig& config, EstimateStage stage, const Theme& theme)
{
    if (!estimate.valid)
        return;
    painter.save();
    paintWedge(painter, viewport, estimate.pose, estimate.lastHeadingSd, 1.35 * config.radius_m, theme);
    const double radius = viewport.toPixels(estimate.radius_m);
    painter.setPen(QPen(theme.estimate, 1.2, stage == EstimateStage::Preview ? Qt::DashLine : Qt::SolidLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(viewport.toPixels(estimate.pose.position), radius, radius);
    paintEllipse(painter, viewport, estimate.pose, estimate.covariance, theme);
    painter.restore();
}

void paintUncertainty(QPainter& painter, const Viewport& viewport, const Pose2& pose,
                      const PoseCovariance& covariance, const AgvConfig& config, const Theme& theme)
{
    painter.save();
    paintWedge(painter, viewport, pose, std::sqrt(std::max(covariance[8], 0.0)), 1.35 * config.radius_m,
               theme);
    paintEllipse(painter, viewport, pose, covariance, theme);
    painter.restore();
}

void paintStops(QPainter& painter, const Viewport& viewport, const TurnEstimate& estimate, const Theme& theme)
{
    const double circle = viewport.toPixels(estimate.radius_m);
    if (!estimate.valid || circle < 8.0)
        return; // smaller than an AGV's number: they would only hide it
    painter.save();
    const bool numbered = circle > 34.0;
    const double size = numbered ? 8.0 : circle < 14.0 ? 1.8 : 3.2;
    QFont font = painter.font();
    font.setPixelSize(10);
    font.setBold(true);
    painter.setFont(font);
    for (std::size_t i = estimate.stops.size(); i-- > 0;) {
        const StopReport& stop = estimate.stops[i];
        const bool suspicious = model::isSuspicious(stop);
        const QPointF at = viewport.toPixels(stop.antenna);
        painter.setPen(QPen(suspicious ? theme.warning : theme.estimate, suspicious ? 2.0 : 1.3));
        painter.setBrush(theme.raised);
        if (suspicious) {
            const double d = 1.35 * size;
            painter.drawPolygon(
                QPolygonF{at + QPointF(0, -d), at + QPointF(d, 0), at + QPointF(0, d), at + QPointF(-d, 0)});
        } else {
            painter.drawEllipse(at, size, size);
        }
        if (!numbered)
            continue;
        painter.setPen(theme.text);
        painter.drawText(QRectF(at - QPointF(10, 10), QSizeF(20, 20)), Qt::AlignCenter,
                         QString::number(i + 1));
    }
    painter.restore();
}

} // namespace agv::gui
