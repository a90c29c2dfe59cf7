// SPDX-License-Identifier: GPL-3.0-or-later
// The AGVs on the map: where they are drawn, and how.
#include "gui/map/agv_painter.h"
#include "gui/map/map_widget.h"
#include "gui/map/turn_painter.h"

#include <QPainter>

namespace agv::gui {

using model::shownEstimate;

namespace {

PoseCertainty certaintyOf(const AgvSnapshot& agv, bool isPreview)
{
    if (isPreview)
        return PoseCertainty::Tentative;
    return agv.poseHealth == PoseHealth::Doubted ? PoseCertainty::Doubted : PoseCertainty::Known;
}

} // namespace

std::optional<Pose2> MapWidget::drawnPose(int robot) const
{
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        if (agv.id.number != robot)
            continue;
        const TurnEstimate* estimate = shownEstimate(agv);
        return estimate ? std::optional(estimate->pose) : agv.pose;
    }
    return {};
}

void MapWidget::paintReads(QPainter& painter) const
{
    const double size = readSize();
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        for (const TagRead& read : agv.recentReads) {
            const auto found = m_tags.find(read.uid);
            if (found == m_tags.end())
                continue;
            const QPointF at = m_viewport.toPixels(found->second);
            painter.setPen(QPen(m_theme.mapFloor, 1.0));
            painter.setBrush(m_theme.floorTagNow);
            painter.drawPolygon(QPolygonF{at + QPointF(0, -size), at + QPointF(size, 0),
                                          at + QPointF(0, size), at + QPointF(-size, 0)});
            if (size < 9.0)
                continue;
            painter.setPen(m_theme.accentText);
            painter.drawText(QRectF(at - QPointF(size, size), QSizeF(2 * size, 2 * size)), Qt::AlignCenter,
                             QString::number(read.rssi));
        }
    }
}

void MapWidget::paintAgvs(QPainter& painter) const
{
    const double range = m_plant.rssiTable.empty() ? 0.0 : m_plant.rssiTable.front().upperEdge;
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        const AgvConfig* config = m_plant.findAgv(agv.id);
        const TurnEstimate* estimate = shownEstimate(agv);
        const std::optional<Pose2> pose = drawnPose(agv.id.number);
        if (!config || !pose)
            continue;
        const bool isPreview = estimate && !agv.turn.result;
        paintAgv(painter, m_viewport,
                 {config, *pose, certaintyOf(agv, isPreview), agv.id.number == m_selected, agv.mayBeMoving},
                 range, m_theme);
        if (!estimate) {
            paintUncertainty(painter, m_viewport, *pose, agv.covariance, *config, m_theme);
            continue;
        }
        paintEstimate(painter, m_viewport, *estimate, *config,
                      isPreview ? EstimateStage::Preview : EstimateStage::Result, m_theme);
        if (!isPreview && estimate->alternative)
            paintAlternative(painter, m_viewport, *config, estimate->alternative->pose, m_theme);
    }
}

} // namespace agv::gui
