// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/map/floor_tag_marks.h"

#include "gui/map/map_agvs.h"

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

void FloorTagMarks::clear()
{
    m_seen.clear();
    m_missing.clear();
    m_unknown.clear();
}

void FloorTagMarks::add(const PlantSnapshot& snapshot)
{
    m_missing.clear();
    m_unknown.clear();
    for (const AgvSnapshot& agv : snapshot.agvs) {
        for (const TagRead& read : agv.recentReads)
            m_seen.insert(read.uid);
        if (const TurnEstimate* estimate = shownEstimate(agv)) {
            for (const StopReport& stop : estimate->stops) {
                m_seen.insert(stop.seen.begin(), stop.seen.end());
                m_missing.insert(stop.missed.begin(), stop.missed.end());
                for (const TagUid uid : stop.unknown) {
                    if (std::ranges::find(m_unknown, uid, &Unknown::uid) == m_unknown.end())
                        m_unknown.push_back({uid, stop.antenna});
                }
            }
        }
    }
    // Missed at one stop and read at another one: it is there.
    std::erase_if(m_missing, [this](TagUid uid) { return m_seen.contains(uid); });
}

FloorTagMarks::State FloorTagMarks::stateOf(TagUid uid) const
{
    return m_missing.contains(uid) ? State::Missing
           : m_seen.contains(uid)  ? State::SeenBefore
                                   : State::NotSeen;
}

void FloorTagMarks::paint(QPainter& painter, const Viewport& viewport, const std::vector<FloorTag>& tags,
                          double tagRadius_m, const Theme& theme) const
{
    if (m_seen.empty() && m_missing.empty() && m_unknown.empty())
        return;
    const QRectF visible = viewport.visibleArea();
    const double radius = std::max(1.3, viewport.toPixels(tagRadius_m));
    for (const FloorTag& tag : tags) {
        const State state = stateOf(tag.uid);
        if (state == State::NotSeen || !visible.contains(tag.position.x, tag.position.y))
            continue;
        const QPointF at = viewport.toPixels(tag.position);
        if (state == State::SeenBefore) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(theme.mutedText);
            painter.drawEllipse(at, std::max(2.2, 0.5 * radius), std::max(2.2, 0.5 * radius));
        } else {
            painter.setPen(QPen(theme.warning, 1.4));
            painter.setBrush(Qt::NoBrush);
            paintMissing(painter, at, std::max(4.5, 0.8 * radius));
        }
    }
    for (const Unknown& unknown : m_unknown)
        paintUnknown(painter, viewport.toPixels(unknown.antenna), theme);
}

} // namespace agv::gui
