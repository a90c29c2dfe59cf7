// SPDX-License-Identifier: GPL-3.0-or-later
// What mouse and keys do on the map.
#include "gui/map/map_widget.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <cmath>
#include <utility>

namespace agv::gui {
namespace {

constexpr double wheelZoomStep = 1.25;
constexpr double panStep_px = 60.0;
constexpr double dragStart_px = 4.0; ///< a press that moves less is a click
constexpr double snapReach_px = 9.0;
constexpr double anchorRaster_m = 0.01;
constexpr double fineAnchorRaster_m = 0.001; ///< with Shift

double pixelDistance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

Point2 onRaster(Point2 place, double raster_m)
{
    return {std::round(place.x / raster_m) * raster_m, std::round(place.y / raster_m) * raster_m};
}

} // namespace

void MapWidget::setTool(MapTool tool)
{
    if (m_tool == tool)
        return;
    m_tool = tool;
    m_movingAnchor.reset();
    m_measuring = false;
    if (tool != MapTool::Measure)
        m_measured.reset();
    setToolCursor();
    update();
    emit toolChanged(tool);
}

void MapWidget::setToolCursor()
{
    setCursor(m_tool == MapTool::MoveAnchors ? Qt::ArrowCursor : Qt::CrossCursor);
}

void MapWidget::measureFrom(Point2 from)
{
    setTool(MapTool::Measure);
    m_measured = MeasureLine{from, from};
    m_measuring = true;
    update();
}

Point2 MapWidget::snapped(QPointF pixel) const
{
    if (const UwbAnchor* anchor = anchorAt(pixel))
        return {anchor->x, anchor->y};
    for (const Station& station : m_plant.stations) {
        if (layers().stations &&
            pixelDistance(m_viewport.toPixels(station.pose.position), pixel) <= snapReach_px)
            return station.pose.position;
    }
    if (const FloorTag* tag = floorTagAt(pixel))
        return tag->position;
    return m_viewport.toPlant(pixel);
}

void MapWidget::wheelEvent(QWheelEvent* event)
{
    m_viewport.zoomAt(event->position(), std::pow(wheelZoomStep, event->angleDelta().y() / 120.0));
    userMoved();
    event->accept();
}

void MapWidget::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton)
        return;
    m_press = m_last = event->position();
    m_dragging = false;
    if (event->button() != Qt::LeftButton)
        return;
    if (m_tool == MapTool::Measure)
        pressMeasure(event->position());
    else if (const UwbAnchor* anchor =
                 m_tool == MapTool::MoveAnchors ? anchorAt(event->position()) : nullptr) {
        m_movingAnchor = anchor->id;
        m_movedTo = {anchor->x, anchor->y};
    }
}

// Either a drag from one end to the other or a click at each of them.
void MapWidget::pressMeasure(QPointF pixel)
{
    const Point2 place = snapped(pixel);
    if (m_measuring) {
        m_measured->to = place;
        m_measuring = false;
    } else {
        m_measured = MeasureLine{place, place};
        m_measuring = true;
    }
    update();
}

void MapWidget::mouseMoveEvent(QMouseEvent* event)
{
    const Point2 p = m_viewport.toPlant(event->position());
    emit pointerMoved(p.x, p.y);
    if (m_measuring && m_measured) {
        m_measured->to = snapped(event->position());
        update();
    }
    if (!(event->buttons() & (Qt::LeftButton | Qt::MiddleButton)))
        return;
    if (!m_dragging && (event->position() - m_press).manhattanLength() < dragStart_px)
        return;
    const bool isFirst = !m_dragging;
    m_dragging = true;
    if (m_movingAnchor) {
        m_movedTo =
            onRaster(p, event->modifiers().testFlag(Qt::ShiftModifier) ? fineAnchorRaster_m : anchorRaster_m);
        update();
        return;
    }
    if (m_tool == MapTool::Measure && event->buttons().testFlag(Qt::LeftButton))
        return;
    if (isFirst) {
        setFollowing(false);
        setCursor(Qt::ClosedHandCursor);
    }
    m_viewport.pan(event->position() - m_last);
    m_last = event->position();
    userMoved();
}

void MapWidget::mouseReleaseEvent(QMouseEvent* event)
{
    setToolCursor();
    const bool dragged = m_dragging;
    m_dragging = false;
    if (event->button() != Qt::LeftButton)
        return;
    if (const std::optional<int> anchor = std::exchange(m_movingAnchor, std::nullopt)) {
        if (dragged)
            emit anchorMoved(*anchor, m_movedTo);
        update();
    } else if (m_tool == MapTool::Measure) {
        m_measuring = m_measuring && !dragged;
    } else if (!dragged) {
        click(event->position());
    }
}

void MapWidget::click(QPointF pixel)
{
    const std::optional<Point2> far =
        layers().minimap ? m_minimap.plantPointAt(pixel, m_viewport, areaOf(m_plant)) : std::nullopt;
    if (far) {
        centreOn(*far);
        return;
    }
    const UwbTagSnapshot* tag = uwbTagAt(pixel);
    m_clickedTag = tag ? std::optional(tag->id) : std::nullopt;
    if (const AgvSnapshot* agv = agvAt(pixel))
        emit robotClicked(agv->id.number);
    update();
}

void MapWidget::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (m_tool == MapTool::Measure)
        mousePressEvent(event); // the second of two quick clicks
    else if (agvAt(event->position()))
        zoomToSelected();
}

void MapWidget::keyPressEvent(QKeyEvent* event)
{
    switch (event->key()) {
    case Qt::Key_Left:
        m_viewport.pan({panStep_px, 0.0});
        break;
    case Qt::Key_Right:
        m_viewport.pan({-panStep_px, 0.0});
        break;
    case Qt::Key_Up:
        m_viewport.pan({0.0, panStep_px});
        break;
    case Qt::Key_Down:
        m_viewport.pan({0.0, -panStep_px});
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomIn();
        return;
    case Qt::Key_Minus:
        zoomOut();
        return;
    default:
        QWidget::keyPressEvent(event);
        return;
    }
    setFollowing(false);
    userMoved();
}

void MapWidget::contextMenuEvent(QContextMenuEvent* event)
{
    // By key: about the middle of what is shown.
    const QPoint at = event->reason() == QContextMenuEvent::Mouse ? event->pos() : rect().center();
    emit menuRequested(mapToGlobal(at), snapped(at));
    event->accept();
}

void MapWidget::focusInEvent(QFocusEvent* event)
{
    const Qt::FocusReason reason = event->reason();
    m_keyboardFocus =
        reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason || reason == Qt::ShortcutFocusReason;
    QWidget::focusInEvent(event);
}

void MapWidget::leaveEvent(QEvent*) { emit pointerLeft(); }

} // namespace agv::gui
